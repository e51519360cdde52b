-- Format 1: studies, cases, attempts, results and histories. schema/queue.sql describes the columns.
-- Kept for the test that all steps together give the tables of schema/queue.sql.

CREATE TABLE studies (
  number        INTEGER PRIMARY KEY,   -- order of submission
  id            TEXT NOT NULL UNIQUE,  -- fig16a-3f9c
  name          TEXT NOT NULL,
  description   TEXT NOT NULL,
  document      TEXT NOT NULL,         -- the study as submitted, JSON
  document_hash TEXT NOT NULL UNIQUE,  -- SHA-256: equal studies are one row
  axes          TEXT NOT NULL,         -- [{"parameter", "values"}]
  submitted_at  INTEGER NOT NULL,
  cancelled_at  INTEGER
);

CREATE TABLE cases (
  number           INTEGER PRIMARY KEY,   -- order of first submission
  id               TEXT NOT NULL UNIQUE,  -- content id: a case that several studies contain is one row
  document         TEXT NOT NULL,         -- canonical, JSON
  state            TEXT NOT NULL DEFAULT 'queued'
                   CHECK (state IN ('queued', 'running', 'done', 'failed', 'diverged', 'cancelled')),
  message          TEXT NOT NULL DEFAULT '',   -- reason of the state, or ''
  cancel_requested INTEGER NOT NULL DEFAULT 0,
  attempt          INTEGER NOT NULL DEFAULT 0,
  crashes          INTEGER NOT NULL DEFAULT 0,
  token            TEXT,      -- of the present claim; a write about the run must present it
  lease_until      INTEGER,
  kt               REAL NOT NULL DEFAULT 0   -- dimensionless time that the run has reached
);
CREATE INDEX cases_by_state ON cases (state, number);

CREATE TABLE study_cases (
  study_id TEXT NOT NULL REFERENCES studies (id),
  position INTEGER NOT NULL,
  case_id  TEXT NOT NULL REFERENCES cases (id),
  PRIMARY KEY (study_id, position)
) WITHOUT ROWID;
CREATE INDEX studies_of_a_case ON study_cases (case_id);

CREATE TABLE attempts (
  case_id    TEXT NOT NULL REFERENCES cases (id),
  attempt    INTEGER NOT NULL,
  handle     TEXT NOT NULL DEFAULT '',   -- the executor's name of the run
  started_at INTEGER NOT NULL,
  ended_at   INTEGER,
  ending     TEXT,      -- done, failed, diverged, interrupted or crashed
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
