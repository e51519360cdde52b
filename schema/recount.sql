-- Fills `tallies`, `waiting` and `totals` from the tables that they sum up: after a change of format and by
-- `capstan doctor --repair`. Priorities, pauses and turns stay as they are.

INSERT OR IGNORE INTO schedule (number, study_id) SELECT number, id FROM studies;

DELETE FROM tallies;
INSERT INTO tallies SELECT * FROM counted_tallies;

DELETE FROM waiting;
INSERT INTO waiting SELECT s.number, p.position, c.id, c.not_before
  FROM study_cases p JOIN studies s ON s.id = p.study_id JOIN cases c ON c.id = p.case_id
  WHERE c.state = 'queued' AND s.cancelled_at IS NULL;
UPDATE schedule SET waiting = (SELECT count(*) FROM waiting WHERE study_number = number);

DELETE FROM totals WHERE what = 'cases';
INSERT INTO totals SELECT 'cases', state, count(*) FROM cases GROUP BY state;
