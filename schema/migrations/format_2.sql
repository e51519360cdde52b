-- Format 2: a schedule of turns, and counts that triggers keep as their cases change.

ALTER TABLE cases ADD COLUMN not_before INTEGER NOT NULL DEFAULT 0;   -- end of the back-off after a crash

-- One row for each study: its turn, and the number of its cases in each state and of each motion.
CREATE TABLE schedule (
  number        INTEGER PRIMARY KEY REFERENCES studies (number),
  study_id      TEXT NOT NULL UNIQUE REFERENCES studies (id),
  priority      INTEGER NOT NULL DEFAULT 0,   -- the higher, the sooner
  is_paused     INTEGER NOT NULL DEFAULT 0,
  served        INTEGER NOT NULL DEFAULT 0,   -- grows with every claim: studies of one priority take turns
  queued        INTEGER NOT NULL DEFAULT 0,
  running       INTEGER NOT NULL DEFAULT 0,
  done          INTEGER NOT NULL DEFAULT 0,
  failed        INTEGER NOT NULL DEFAULT 0,
  diverged      INTEGER NOT NULL DEFAULT 0,
  cancelled     INTEGER NOT NULL DEFAULT 0,
  tumbling      INTEGER NOT NULL DEFAULT 0,
  tank_treading INTEGER NOT NULL DEFAULT 0,
  transition    INTEGER NOT NULL DEFAULT 0,
  undecided     INTEGER NOT NULL DEFAULT 0
);
CREATE INDEX turns ON schedule (priority DESC, served) WHERE queued > 0 AND is_paused = 0;
CREATE INDEX schedule_by_served ON schedule (served);

-- The queued cases of the studies that are not cancelled.
CREATE TABLE waiting (
  study_number INTEGER NOT NULL REFERENCES studies (number),
  position     INTEGER NOT NULL,
  case_id      TEXT NOT NULL REFERENCES cases (id),
  not_before   INTEGER NOT NULL,
  PRIMARY KEY (study_number, position)
) WITHOUT ROWID;
CREATE INDEX waiting_by_case ON waiting (case_id);

-- Cases that are partly computed: progress of a study counts their computed part.
CREATE INDEX cases_begun ON cases (id) WHERE kt > 0 AND state IN ('queued', 'running');

CREATE TRIGGER study_is_scheduled AFTER INSERT ON studies BEGIN
  INSERT INTO schedule (number, study_id) VALUES (NEW.number, NEW.id);
END;

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
    undecided     = undecided     + (c.motion IS 'undecided')
    FROM (SELECT state, motion FROM cases LEFT JOIN results ON case_id = id WHERE id = NEW.case_id) c
    WHERE study_id = NEW.study_id;
  INSERT INTO waiting SELECT s.number, NEW.position, c.id, c.not_before FROM studies s, cases c
    WHERE s.id = NEW.study_id AND c.id = NEW.case_id AND c.state = 'queued' AND s.cancelled_at IS NULL;
END;

CREATE TRIGGER case_changes_state AFTER UPDATE OF state ON cases WHEN NEW.state <> OLD.state BEGIN
  UPDATE schedule SET
    queued    = queued    + (NEW.state = 'queued')    - (OLD.state = 'queued'),
    running   = running   + (NEW.state = 'running')   - (OLD.state = 'running'),
    done      = done      + (NEW.state = 'done')      - (OLD.state = 'done'),
    failed    = failed    + (NEW.state = 'failed')    - (OLD.state = 'failed'),
    diverged  = diverged  + (NEW.state = 'diverged')  - (OLD.state = 'diverged'),
    cancelled = cancelled + (NEW.state = 'cancelled') - (OLD.state = 'cancelled')
    WHERE study_id IN (SELECT study_id FROM study_cases WHERE case_id = NEW.id);
  DELETE FROM waiting WHERE case_id = NEW.id;
  INSERT INTO waiting SELECT s.number, w.position, NEW.id, NEW.not_before
    FROM study_cases w JOIN studies s ON s.id = w.study_id
    WHERE w.case_id = NEW.id AND NEW.state = 'queued' AND s.cancelled_at IS NULL;
END;

CREATE TRIGGER study_is_cancelled AFTER UPDATE OF cancelled_at ON studies
WHEN (NEW.cancelled_at IS NULL) <> (OLD.cancelled_at IS NULL) BEGIN
  DELETE FROM waiting WHERE study_number = NEW.number;
  INSERT INTO waiting SELECT NEW.number, w.position, c.id, c.not_before
    FROM study_cases w JOIN cases c ON c.id = w.case_id
    WHERE w.study_id = NEW.id AND c.state = 'queued' AND NEW.cancelled_at IS NULL;
END;

CREATE TRIGGER motion_is_known AFTER INSERT ON results WHEN NEW.motion IS NOT NULL BEGIN
  UPDATE schedule SET
    tumbling      = tumbling      + (NEW.motion = 'tumbling'),
    tank_treading = tank_treading + (NEW.motion = 'tank_treading'),
    transition    = transition    + (NEW.motion = 'transition'),
    undecided     = undecided     + (NEW.motion = 'undecided')
    WHERE study_id IN (SELECT study_id FROM study_cases WHERE case_id = NEW.case_id);
END;

CREATE TRIGGER motion_is_forgotten AFTER DELETE ON results WHEN OLD.motion IS NOT NULL BEGIN
  UPDATE schedule SET
    tumbling      = tumbling      - (OLD.motion = 'tumbling'),
    tank_treading = tank_treading - (OLD.motion = 'tank_treading'),
    transition    = transition    - (OLD.motion = 'transition'),
    undecided     = undecided     - (OLD.motion = 'undecided')
    WHERE study_id IN (SELECT study_id FROM study_cases WHERE case_id = OLD.case_id);
END;

-- POST /v1/studies with an Idempotency-Key: the hash of the study that was sent with the key.
CREATE TABLE idempotency_keys (
  key           TEXT PRIMARY KEY,
  document_hash TEXT NOT NULL,
  used_at       INTEGER NOT NULL
) WITHOUT ROWID;
