-- Format 4: progress of a study is weighted by the cost of its cases. A case at two positions of a study, after a
-- replacement, counts twice in all sums.

ALTER TABLE cases ADD COLUMN cost REAL NOT NULL DEFAULT 0;   -- estimated seconds of one core; 0: not estimated yet
CREATE INDEX cases_without_cost ON cases (id) WHERE cost = 0;   -- empty after the first start

ALTER TABLE schedule ADD COLUMN cost_total REAL NOT NULL DEFAULT 0;   -- of all its cases
ALTER TABLE schedule ADD COLUMN cost_ended REAL NOT NULL DEFAULT 0;   -- of those that have ended

DROP TRIGGER case_joins_study;
CREATE TRIGGER case_joins_study AFTER INSERT ON study_cases BEGIN
  UPDATE schedule SET
    queued        = queued        + (c.state = 'queued'),
    running       = running       + (c.state = 'running'),
    done          = done          + (c.state = 'done'),
    failed        = failed        + (c.state = 'failed'),
    diverged      = diverged      + (c.state = 'diverged'),
    cancelled     = cancelled     + (c.state = 'cancelled'),
    tumbling      = tumbling      + (c.motion IS 'tumbling'),
    tank_treading = tank_treading + (c.motion IS 'tank_treading'),
    transition    = transition    + (c.motion IS 'transition'),
    undecided     = undecided     + (c.motion IS 'undecided'),
    cost_total    = cost_total    + c.cost,
    cost_ended    = cost_ended    + c.cost * (c.state NOT IN ('queued', 'running'))
    FROM (SELECT state, motion, cost FROM cases LEFT JOIN results ON case_id = id WHERE id = NEW.case_id) c
    WHERE study_id = NEW.study_id;
  INSERT INTO waiting SELECT s.number, NEW.position, c.id, c.not_before FROM studies s, cases c
    WHERE s.id = NEW.study_id AND c.id = NEW.case_id AND c.state = 'queued' AND s.cancelled_at IS NULL;
END;

DROP TRIGGER case_changes_state;
CREATE TRIGGER case_changes_state AFTER UPDATE OF state ON cases WHEN NEW.state <> OLD.state BEGIN
  UPDATE schedule SET
    queued    = queued    + w.places * ((NEW.state = 'queued')    - (OLD.state = 'queued')),
    running   = running   + w.places * ((NEW.state = 'running')   - (OLD.state = 'running')),
    done      = done      + w.places * ((NEW.state = 'done')      - (OLD.state = 'done')),
    failed    = failed    + w.places * ((NEW.state = 'failed')    - (OLD.state = 'failed')),
    diverged  = diverged  + w.places * ((NEW.state = 'diverged')  - (OLD.state = 'diverged')),
    cancelled = cancelled + w.places * ((NEW.state = 'cancelled') - (OLD.state = 'cancelled')),
    cost_ended = cost_ended + w.places * NEW.cost
      * ((OLD.state IN ('queued', 'running')) - (NEW.state IN ('queued', 'running')))
    FROM (SELECT study_id, count(*) places FROM study_cases WHERE case_id = NEW.id GROUP BY study_id) w
    WHERE schedule.study_id = w.study_id;
  DELETE FROM waiting WHERE case_id = NEW.id;
  INSERT INTO waiting SELECT s.number, w.position, NEW.id, NEW.not_before
    FROM study_cases w JOIN studies s ON s.id = w.study_id
    WHERE w.case_id = NEW.id AND NEW.state = 'queued' AND s.cancelled_at IS NULL;
END;

DROP TRIGGER case_leaves_study;
CREATE TRIGGER case_leaves_study AFTER DELETE ON study_cases BEGIN
  UPDATE schedule SET
    queued        = queued        - (c.state = 'queued'),
    running       = running       - (c.state = 'running'),
    done          = done          - (c.state = 'done'),
    failed        = failed        - (c.state = 'failed'),
    diverged      = diverged      - (c.state = 'diverged'),
    cancelled     = cancelled     - (c.state = 'cancelled'),
    tumbling      = tumbling      - (c.motion IS 'tumbling'),
    tank_treading = tank_treading - (c.motion IS 'tank_treading'),
    transition    = transition    - (c.motion IS 'transition'),
    undecided     = undecided     - (c.motion IS 'undecided'),
    cost_total    = cost_total    - c.cost,
    cost_ended    = cost_ended    - c.cost * (c.state NOT IN ('queued', 'running'))
    FROM (SELECT state, motion, cost FROM cases LEFT JOIN results ON case_id = id WHERE id = OLD.case_id) c
    WHERE study_id = OLD.study_id;
  DELETE FROM waiting
    WHERE study_number = (SELECT number FROM studies WHERE id = OLD.study_id) AND position = OLD.position;
END;

DROP TRIGGER motion_is_known;
CREATE TRIGGER motion_is_known AFTER INSERT ON results WHEN NEW.motion IS NOT NULL BEGIN
  UPDATE schedule SET
    tumbling      = tumbling      + w.places * (NEW.motion = 'tumbling'),
    tank_treading = tank_treading + w.places * (NEW.motion = 'tank_treading'),
    transition    = transition    + w.places * (NEW.motion = 'transition'),
    undecided     = undecided     + w.places * (NEW.motion = 'undecided')
    FROM (SELECT study_id, count(*) places FROM study_cases WHERE case_id = NEW.case_id GROUP BY study_id) w
    WHERE schedule.study_id = w.study_id;
END;

DROP TRIGGER motion_is_forgotten;
CREATE TRIGGER motion_is_forgotten AFTER DELETE ON results WHEN OLD.motion IS NOT NULL BEGIN
  UPDATE schedule SET
    tumbling      = tumbling      - w.places * (OLD.motion = 'tumbling'),
    tank_treading = tank_treading - w.places * (OLD.motion = 'tank_treading'),
    transition    = transition    - w.places * (OLD.motion = 'transition'),
    undecided     = undecided     - w.places * (OLD.motion = 'undecided')
    FROM (SELECT study_id, count(*) places FROM study_cases WHERE case_id = OLD.case_id GROUP BY study_id) w
    WHERE schedule.study_id = w.study_id;
END;

CREATE TRIGGER cost_is_known AFTER UPDATE OF cost ON cases WHEN NEW.cost <> OLD.cost BEGIN
  UPDATE schedule SET
    cost_total = cost_total + w.places * (NEW.cost - OLD.cost),
    cost_ended = cost_ended + w.places * (NEW.cost - OLD.cost) * (NEW.state NOT IN ('queued', 'running'))
    FROM (SELECT study_id, count(*) places FROM study_cases WHERE case_id = NEW.id GROUP BY study_id) w
    WHERE schedule.study_id = w.study_id;
END;
