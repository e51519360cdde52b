-- Format 5: a row of study_cases is a point of the study, with the values asked for. Several points may resolve to one
-- case: it is computed once.

ALTER TABLE study_cases ADD COLUMN asked TEXT;   -- {"Ca": 0.25, "fluid": "auto", ..}; NULL until derived for an older study
ALTER TABLE studies ADD COLUMN notes TEXT NOT NULL DEFAULT '[]';   -- sentences for the author: consequences of the document that may surprise
CREATE INDEX points_without_values ON study_cases (study_id) WHERE asked IS NULL;   -- empty after the first start

-- Counts by state and sums of costs concern the study's distinct cases, counts by motion its points. Cancelled cases
-- do not count as computed.
ALTER TABLE schedule ADD COLUMN points INTEGER NOT NULL DEFAULT 0;

-- Equal documents that write their numbers differently are one study from now on: stored keys no longer apply.
DELETE FROM idempotency_keys;

DROP TRIGGER case_joins_study;
CREATE TRIGGER case_joins_study AFTER INSERT ON study_cases BEGIN
  UPDATE schedule SET
    points        = points        + 1,
    queued        = queued        + c.is_new * (c.state = 'queued'),
    running       = running       + c.is_new * (c.state = 'running'),
    done          = done          + c.is_new * (c.state = 'done'),
    failed        = failed        + c.is_new * (c.state = 'failed'),
    diverged      = diverged      + c.is_new * (c.state = 'diverged'),
    cancelled     = cancelled     + c.is_new * (c.state = 'cancelled'),
    cost_total    = cost_total    + c.is_new * c.cost,
    cost_ended    = cost_ended    + c.is_new * c.cost * (c.state NOT IN ('queued', 'running', 'cancelled')),
    tumbling      = tumbling      + (c.motion IS 'tumbling'),
    tank_treading = tank_treading + (c.motion IS 'tank_treading'),
    transition    = transition    + (c.motion IS 'transition'),
    undecided     = undecided     + (c.motion IS 'undecided')
    FROM (SELECT state, motion, cost,
                 (SELECT count(*) FROM study_cases WHERE case_id = NEW.case_id AND study_id = NEW.study_id) = 1 is_new
          FROM cases LEFT JOIN results ON case_id = id WHERE id = NEW.case_id) c
    WHERE study_id = NEW.study_id;
  INSERT INTO waiting SELECT s.number, NEW.position, c.id, c.not_before FROM studies s, cases c
    WHERE s.id = NEW.study_id AND c.id = NEW.case_id AND c.state = 'queued' AND s.cancelled_at IS NULL;
END;

DROP TRIGGER case_leaves_study;
CREATE TRIGGER case_leaves_study AFTER DELETE ON study_cases BEGIN
  UPDATE schedule SET
    points        = points        - 1,
    queued        = queued        - c.is_gone * (c.state = 'queued'),
    running       = running       - c.is_gone * (c.state = 'running'),
    done          = done          - c.is_gone * (c.state = 'done'),
    failed        = failed        - c.is_gone * (c.state = 'failed'),
    diverged      = diverged      - c.is_gone * (c.state = 'diverged'),
    cancelled     = cancelled     - c.is_gone * (c.state = 'cancelled'),
    cost_total    = cost_total    - c.is_gone * c.cost,
    cost_ended    = cost_ended    - c.is_gone * c.cost * (c.state NOT IN ('queued', 'running', 'cancelled')),
    tumbling      = tumbling      - (c.motion IS 'tumbling'),
    tank_treading = tank_treading - (c.motion IS 'tank_treading'),
    transition    = transition    - (c.motion IS 'transition'),
    undecided     = undecided     - (c.motion IS 'undecided')
    FROM (SELECT state, motion, cost,
                 NOT EXISTS (SELECT 1 FROM study_cases WHERE case_id = OLD.case_id AND study_id = OLD.study_id) is_gone
          FROM cases LEFT JOIN results ON case_id = id WHERE id = OLD.case_id) c
    WHERE study_id = OLD.study_id;
  DELETE FROM waiting
    WHERE study_number = (SELECT number FROM studies WHERE id = OLD.study_id) AND position = OLD.position;
END;

DROP TRIGGER case_changes_state;
CREATE TRIGGER case_changes_state AFTER UPDATE OF state ON cases WHEN NEW.state <> OLD.state BEGIN
  UPDATE schedule SET
    queued     = queued     + (NEW.state = 'queued')    - (OLD.state = 'queued'),
    running    = running    + (NEW.state = 'running')   - (OLD.state = 'running'),
    done       = done       + (NEW.state = 'done')      - (OLD.state = 'done'),
    failed     = failed     + (NEW.state = 'failed')    - (OLD.state = 'failed'),
    diverged   = diverged   + (NEW.state = 'diverged')  - (OLD.state = 'diverged'),
    cancelled  = cancelled  + (NEW.state = 'cancelled') - (OLD.state = 'cancelled'),
    cost_ended = cost_ended
      + NEW.cost * ((OLD.state IN ('queued', 'running', 'cancelled')) - (NEW.state IN ('queued', 'running', 'cancelled')))
    WHERE study_id IN (SELECT study_id FROM study_cases WHERE case_id = NEW.id);
  DELETE FROM waiting WHERE case_id = NEW.id;
  INSERT INTO waiting SELECT s.number, w.position, NEW.id, NEW.not_before
    FROM study_cases w JOIN studies s ON s.id = w.study_id
    WHERE w.case_id = NEW.id AND NEW.state = 'queued' AND s.cancelled_at IS NULL;
END;

DROP TRIGGER cost_is_known;
CREATE TRIGGER cost_is_known AFTER UPDATE OF cost ON cases WHEN NEW.cost <> OLD.cost BEGIN
  UPDATE schedule SET
    cost_total = cost_total + NEW.cost - OLD.cost,
    cost_ended = cost_ended + (NEW.cost - OLD.cost) * (NEW.state NOT IN ('queued', 'running', 'cancelled'))
    WHERE study_id IN (SELECT study_id FROM study_cases WHERE case_id = NEW.id);
END;

-- Runs that failed have no motion; older solvers labelled them by their history.
UPDATE results SET motion = NULL
  WHERE motion IS NOT NULL AND case_id IN (SELECT id FROM cases WHERE state <> 'done');

-- Cases by state and attempts by ending over all studies, for monitoring. Counting a million rows for each request
-- would take a third of a second. Attempts of deleted cases stay counted.
CREATE TABLE totals (
  what  TEXT NOT NULL,   -- 'cases' or 'attempts'
  name  TEXT NOT NULL,   -- a state of cases, or an ending of attempts
  count INTEGER NOT NULL,
  PRIMARY KEY (what, name)
) WITHOUT ROWID;
INSERT INTO totals SELECT 'attempts', ending, count(*) FROM attempts WHERE ending IS NOT NULL GROUP BY ending;

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

-- Cases of deleted studies that no other study contains. Their rows are deleted first, then their run directories, then
-- their row here: a daemon that is killed in between continues with the rest.
CREATE TABLE unwanted_cases (case_id TEXT PRIMARY KEY) WITHOUT ROWID;
CREATE INDEX replaced_cases ON study_cases (replaces) WHERE replaces IS NOT NULL;
