-- Tables of the daemon's database, format 7. schema/migrations/ has one script for each step from a format to the next:
-- an older database runs the scripts that it lacks, a new one is made from this file. Both have the same tables.
--
-- Times are milliseconds since 1970, UTC. The daemon is the only writer. schema/life_cycle.md draws the states of a case.

CREATE TABLE studies (
  number        INTEGER PRIMARY KEY,   -- order of submission
  id            TEXT NOT NULL UNIQUE,  -- name and digits of the hash: fig16a-3f9c
  name          TEXT NOT NULL,
  description   TEXT NOT NULL,
  document      TEXT NOT NULL,         -- the study as submitted, JSON
  document_hash TEXT NOT NULL UNIQUE,  -- numerics version and SHA-256 of the document: equal studies are one row
  axes          TEXT NOT NULL,         -- [{"parameter", "values"}]
  submitted_at  INTEGER NOT NULL,
  cancelled_at  INTEGER,
  notes         TEXT NOT NULL DEFAULT '[]'   -- sentences for the author: consequences of the document that may surprise
);

CREATE TABLE cases (
  number           INTEGER PRIMARY KEY,   -- order of first submission
  id               TEXT NOT NULL UNIQUE,  -- content id: a case that several studies contain is one row
  document         TEXT NOT NULL,         -- canonical, JSON
  state            TEXT NOT NULL DEFAULT 'queued'
                   CHECK (state IN ('queued', 'running', 'done', 'failed', 'diverged', 'cancelled')),
  message          TEXT NOT NULL DEFAULT '',         -- reason of the state, or ''
  cancel_requested INTEGER NOT NULL DEFAULT 0,       -- 1: the case runs and is to be cancelled
  attempt          INTEGER NOT NULL DEFAULT 0,       -- number of the last attempt, from 1
  crashes          INTEGER NOT NULL DEFAULT 0,
  token            TEXT,                             -- of the present claim; a write about the run must present it
  lease_until      INTEGER,
  kt               REAL NOT NULL DEFAULT 0,          -- dimensionless time that the run has reached
  not_before       INTEGER NOT NULL DEFAULT 0,       -- end of the back-off after a crash
  numerics         INTEGER NOT NULL DEFAULT 1,       -- numerics version of the solver, part of the id
  cost             REAL NOT NULL DEFAULT 0,          -- estimated seconds of one core; 0: not estimated yet
  steps_id         TEXT NOT NULL DEFAULT ''          -- equal for cases that differ in the end of the run only
);
CREATE INDEX cases_to_go_on_from ON cases (steps_id, kt) WHERE state = 'done';
CREATE INDEX cases_by_state ON cases (state, number);
CREATE INDEX cases_begun ON cases (id) WHERE kt > 0 AND state IN ('queued', 'running');   -- partly computed
CREATE INDEX cases_without_cost ON cases (id) WHERE cost = 0;   -- of older programs; empty after the first start

-- The points of a study. Several points may resolve to one case: it is computed once.
CREATE TABLE study_cases (
  study_id TEXT NOT NULL REFERENCES studies (id),
  position INTEGER NOT NULL,                    -- from 0, in the order of the study
  case_id  TEXT NOT NULL REFERENCES cases (id),
  replaces TEXT,                                -- the case of this point before a retry or a new numerics version
  asked    TEXT,                                -- {"Ca": 0.25, "fluid": "auto", ..}; NULL until derived for an older study
  PRIMARY KEY (study_id, position)
) WITHOUT ROWID;
CREATE INDEX studies_of_a_case ON study_cases (case_id);
CREATE INDEX replaced_cases ON study_cases (replaces) WHERE replaces IS NOT NULL;
CREATE INDEX points_without_values ON study_cases (study_id) WHERE asked IS NULL;   -- empty after the first start

CREATE TABLE attempts (
  case_id    TEXT NOT NULL REFERENCES cases (id),
  attempt    INTEGER NOT NULL,
  handle     TEXT NOT NULL DEFAULT '',   -- the executor's name for the run
  started_at INTEGER NOT NULL,
  ended_at   INTEGER,
  ending     TEXT,                       -- done, failed, diverged, interrupted or crashed; NULL while it runs
  reason     TEXT,
  PRIMARY KEY (case_id, attempt)
) WITHOUT ROWID;

CREATE TABLE results (
  case_id  TEXT PRIMARY KEY REFERENCES cases (id),
  motion   TEXT,            -- tumbling, tank_treading, transition or undecided; NULL after a numerical failure
  document TEXT NOT NULL    -- result.json
) WITHOUT ROWID;

CREATE TABLE histories (
  case_id TEXT NOT NULL REFERENCES cases (id),
  record  INTEGER NOT NULL,
  kt REAL, D_xy REAL, theta REAL, psi REAL, volume REAL, area REAL,
  PRIMARY KEY (case_id, record)
) WITHOUT ROWID;

-- POST /v1/studies with an Idempotency-Key: the hash of the study that was sent with the key.
CREATE TABLE idempotency_keys (
  key           TEXT PRIMARY KEY,
  document_hash TEXT NOT NULL,
  used_at       INTEGER NOT NULL
) WITHOUT ROWID;

-- Cases of deleted studies that no other study contains. Their rows are deleted first, then their run directories, then
-- their row here: a daemon that is killed in between continues with the rest.
CREATE TABLE unwanted_cases (case_id TEXT PRIMARY KEY) WITHOUT ROWID;

-- The order in which studies are served -------------------------------------------------------------------------------

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

-- The queued points of the studies that are not cancelled.
CREATE TABLE waiting (
  study_number INTEGER NOT NULL REFERENCES studies (number),
  position     INTEGER NOT NULL,
  case_id      TEXT NOT NULL REFERENCES cases (id),
  not_before   INTEGER NOT NULL,
  PRIMARY KEY (study_number, position)
) WITHOUT ROWID;
CREATE INDEX waiting_by_case ON waiting (case_id);

CREATE TRIGGER study_is_scheduled AFTER INSERT ON studies BEGIN
  INSERT INTO schedule (number, study_id) VALUES (NEW.number, NEW.id);
END;

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

-- Counts: triggers update them at each change of a case, so no program can leave them wrong -----------------------------

-- One row for each state: number and summed cost of the study's distinct cases. One row for each motion: number of its
-- points. One row 'points': number of all its points.
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

-- Over all studies, for monitoring: cases by state, attempts by ending. Attempts of deleted cases stay counted.
CREATE TABLE totals (
  what  TEXT NOT NULL,   -- 'cases' or 'attempts'
  name  TEXT NOT NULL,   -- a state of cases, or an ending of attempts
  count INTEGER NOT NULL,
  PRIMARY KEY (what, name)
) WITHOUT ROWID;

CREATE TRIGGER case_is_counted AFTER INSERT ON cases BEGIN
  INSERT INTO totals VALUES ('cases', NEW.state, 1) ON CONFLICT DO UPDATE SET count = count + 1;
END;
CREATE TRIGGER case_is_counted_anew AFTER UPDATE OF state ON cases WHEN NEW.state <> OLD.state BEGIN
  UPDATE totals SET count = count - 1 WHERE what = 'cases' AND name = OLD.state;
  INSERT INTO totals VALUES ('cases', NEW.state, 1) ON CONFLICT DO UPDATE SET count = count + 1;
END;
CREATE TRIGGER case_is_deleted AFTER DELETE ON cases BEGIN
  UPDATE totals SET count = count - 1 WHERE what = 'cases' AND name = OLD.state;
END;
CREATE TRIGGER attempt_is_counted AFTER UPDATE OF ending ON attempts WHEN OLD.ending IS NULL AND NEW.ending IS NOT NULL
BEGIN
  INSERT INTO totals VALUES ('attempts', NEW.ending, 1) ON CONFLICT DO UPDATE SET count = count + 1;
END;
