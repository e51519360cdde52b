-- Fills `schedule`, `waiting` and `totals` from the tables that they sum up: after a change of format, and by `capstan doctor`.
-- What an operator has chosen (priority, pause) and whose turn it is stay.
INSERT OR IGNORE INTO schedule (number, study_id) SELECT number, id FROM studies;

UPDATE schedule SET points = 0, queued = 0, running = 0, done = 0, failed = 0, diverged = 0, cancelled = 0,
                    tumbling = 0, tank_treading = 0, transition = 0, undecided = 0, cost_total = 0, cost_ended = 0;

UPDATE schedule SET
  queued = c.queued, running = c.running, done = c.done, failed = c.failed, diverged = c.diverged,
  cancelled = c.cancelled, cost_total = c.cost_total, cost_ended = c.cost_ended
  FROM (SELECT study_id,
               sum(state = 'queued') queued, sum(state = 'running') running, sum(state = 'done') done,
               sum(state = 'failed') failed, sum(state = 'diverged') diverged,
               sum(state = 'cancelled') cancelled,
               sum(cost) cost_total, sum(cost * (state NOT IN ('queued', 'running', 'cancelled'))) cost_ended
        FROM (SELECT DISTINCT study_id, case_id FROM study_cases) w JOIN cases ON id = w.case_id
        GROUP BY study_id) c
  WHERE schedule.study_id = c.study_id;

UPDATE schedule SET
  points = c.points, tumbling = c.tumbling, tank_treading = c.tank_treading, transition = c.transition,
  undecided = c.undecided
  FROM (SELECT study_id, count(*) points,
               sum(motion IS 'tumbling') tumbling, sum(motion IS 'tank_treading') tank_treading,
               sum(motion IS 'transition') transition, sum(motion IS 'undecided') undecided
        FROM study_cases w LEFT JOIN results r ON r.case_id = w.case_id
        GROUP BY study_id) c
  WHERE schedule.study_id = c.study_id;

DELETE FROM waiting;
INSERT INTO waiting SELECT s.number, w.position, c.id, c.not_before
  FROM study_cases w JOIN studies s ON s.id = w.study_id JOIN cases c ON c.id = w.case_id
  WHERE c.state = 'queued' AND s.cancelled_at IS NULL;

DELETE FROM totals WHERE what = 'cases';
INSERT INTO totals SELECT 'cases', state, count(*) FROM cases GROUP BY state;
