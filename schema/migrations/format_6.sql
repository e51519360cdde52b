-- Format 6: a table of counts by word takes the place of ten columns of `schedule`. schema/recount.sql fills it.

DROP TRIGGER case_joins_study;
DROP TRIGGER case_leaves_study;
DROP TRIGGER case_changes_state;
DROP TRIGGER study_is_cancelled;
DROP TRIGGER cost_is_known;
DROP TRIGGER motion_is_known;
DROP TRIGGER motion_is_forgotten;

CREATE TABLE old_schedule AS SELECT number, study_id, priority, is_paused, served FROM schedule;
DROP TABLE schedule;   -- with its indices
CREATE TABLE schedule (
  number    INTEGER PRIMARY KEY REFERENCES studies (number),
  study_id  TEXT NOT NULL UNIQUE REFERENCES studies (id),
  priority  INTEGER NOT NULL DEFAULT 0,   -- the higher, the sooner
  is_paused INTEGER NOT NULL DEFAULT 0,
  served    INTEGER NOT NULL DEFAULT 0,   -- grows with every claim: studies of one priority take turns
  waiting   INTEGER NOT NULL DEFAULT 0    -- number of the study's rows in the table `waiting`
);
CREATE INDEX turns ON schedule (priority DESC, served) WHERE waiting > 0 AND is_paused = 0;
CREATE INDEX schedule_by_served ON schedule (served);

INSERT INTO schedule (number, study_id, priority, is_paused, served) SELECT * FROM old_schedule;
DROP TABLE old_schedule;

CREATE TRIGGER point_waits AFTER INSERT ON waiting BEGIN
  UPDATE schedule SET waiting = waiting + 1 WHERE number = NEW.study_number;
END;
CREATE TRIGGER point_waits_no_longer AFTER DELETE ON waiting BEGIN
  UPDATE schedule SET waiting = waiting - 1 WHERE number = OLD.study_number;
END;

CREATE TRIGGER new_point_waits AFTER INSERT ON study_cases BEGIN
  INSERT INTO waiting SELECT s.number, NEW.position, c.id, c.not_before FROM studies s, cases c
    WHERE s.id = NEW.study_id AND c.id = NEW.case_id AND c.state = 'queued' AND s.cancelled_at IS NULL;
END;
CREATE TRIGGER removed_point_waits_no_longer AFTER DELETE ON study_cases BEGIN
  DELETE FROM waiting
    WHERE study_number = (SELECT number FROM studies WHERE id = OLD.study_id) AND position = OLD.position;
END;

CREATE TRIGGER queued_case_waits AFTER UPDATE OF state ON cases WHEN NEW.state <> OLD.state BEGIN
  DELETE FROM waiting WHERE case_id = NEW.id;
  INSERT INTO waiting SELECT s.number, p.position, NEW.id, NEW.not_before
    FROM study_cases p JOIN studies s ON s.id = p.study_id
    WHERE p.case_id = NEW.id AND NEW.state = 'queued' AND s.cancelled_at IS NULL;
END;

CREATE TRIGGER cancelled_study_does_not_wait AFTER UPDATE OF cancelled_at ON studies
WHEN (NEW.cancelled_at IS NULL) <> (OLD.cancelled_at IS NULL) BEGIN
  DELETE FROM waiting WHERE study_number = NEW.number;
  INSERT INTO waiting SELECT NEW.number, p.position, c.id, c.not_before
    FROM study_cases p JOIN cases c ON c.id = p.case_id
    WHERE p.study_id = NEW.id AND c.state = 'queued' AND NEW.cancelled_at IS NULL;
END;

CREATE TABLE tallies (
  study_id TEXT NOT NULL REFERENCES studies (id),
  word     TEXT NOT NULL,   -- a state, a motion or 'points'
  count    INTEGER NOT NULL,
  cost     REAL NOT NULL,   -- estimated seconds of one core; 0 for motions and points
  PRIMARY KEY (study_id, word)
) WITHOUT ROWID;

-- The values that `tallies` must have, counted from the cases; for schema/recount.sql and `capstan doctor`.
CREATE VIEW counted_tallies (study_id, word, count, cost) AS
  SELECT study_id, state, count(*), total(cost)
    FROM (SELECT DISTINCT study_id, case_id FROM study_cases) JOIN cases ON id = case_id GROUP BY study_id, state
  UNION ALL
  SELECT study_id, motion, count(*), 0.0
    FROM study_cases JOIN results USING (case_id) WHERE motion IS NOT NULL GROUP BY study_id, motion
  UNION ALL
  SELECT study_id, 'points', count(*), 0.0 FROM study_cases GROUP BY study_id;

CREATE TRIGGER new_point_is_counted AFTER INSERT ON study_cases BEGIN
  INSERT INTO tallies VALUES (NEW.study_id, 'points', 1, 0) ON CONFLICT DO UPDATE SET count = count + 1;
  INSERT INTO tallies SELECT NEW.study_id, motion, 1, 0 FROM results WHERE case_id = NEW.case_id AND motion IS NOT NULL
    ON CONFLICT DO UPDATE SET count = count + 1;
  INSERT INTO tallies SELECT NEW.study_id, state, 1, cases.cost FROM cases WHERE id = NEW.case_id AND NOT EXISTS
    (SELECT 1 FROM study_cases WHERE case_id = NEW.case_id AND study_id = NEW.study_id AND position <> NEW.position)
    ON CONFLICT DO UPDATE SET count = count + 1, cost = cost + excluded.cost;
END;
CREATE TRIGGER removed_point_is_not_counted AFTER DELETE ON study_cases BEGIN
  UPDATE tallies SET count = count - 1 WHERE study_id = OLD.study_id AND word = 'points';
  UPDATE tallies SET count = count - 1
    WHERE study_id = OLD.study_id AND word = (SELECT motion FROM results WHERE case_id = OLD.case_id);
  UPDATE tallies SET count = count - 1, cost = tallies.cost - c.cost
    FROM (SELECT state, cost FROM cases WHERE id = OLD.case_id) c
    WHERE study_id = OLD.study_id AND word = c.state AND NOT EXISTS
      (SELECT 1 FROM study_cases WHERE case_id = OLD.case_id AND study_id = OLD.study_id);
END;

CREATE TRIGGER changed_case_is_counted AFTER UPDATE OF state, cost ON cases
WHEN NEW.state <> OLD.state OR NEW.cost <> OLD.cost BEGIN
  UPDATE tallies SET count = count - 1, cost = cost - OLD.cost
    WHERE word = OLD.state AND study_id IN (SELECT study_id FROM study_cases WHERE case_id = NEW.id);
  INSERT INTO tallies SELECT DISTINCT study_id, NEW.state, 1, NEW.cost FROM study_cases WHERE case_id = NEW.id
    ON CONFLICT DO UPDATE SET count = count + 1, cost = cost + excluded.cost;
END;

CREATE TRIGGER motion_is_counted AFTER INSERT ON results WHEN NEW.motion IS NOT NULL BEGIN
  INSERT INTO tallies SELECT study_id, NEW.motion, count(*), 0 FROM study_cases WHERE case_id = NEW.case_id GROUP BY study_id
    ON CONFLICT DO UPDATE SET count = count + excluded.count;
END;
CREATE TRIGGER removed_motion_is_not_counted AFTER DELETE ON results WHEN OLD.motion IS NOT NULL BEGIN
  UPDATE tallies SET count = tallies.count - p.points
    FROM (SELECT study_id, count(*) points FROM study_cases WHERE case_id = OLD.case_id GROUP BY study_id) p
    WHERE tallies.study_id = p.study_id AND word = OLD.motion;
END;
