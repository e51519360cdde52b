-- Format 3: a case of a study can be replaced by another: at a finer fidelity, or of a later numerics version.

ALTER TABLE study_cases ADD COLUMN replaces TEXT;   -- the case that was at this position before

ALTER TABLE cases ADD COLUMN numerics INTEGER NOT NULL DEFAULT 1;   -- numerics version of the solver, part of the id

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
    undecided     = undecided     - (c.motion IS 'undecided')
    FROM (SELECT state, motion FROM cases LEFT JOIN results ON case_id = id WHERE id = OLD.case_id) c
    WHERE study_id = OLD.study_id;
  DELETE FROM waiting
    WHERE study_number = (SELECT number FROM studies WHERE id = OLD.study_id) AND position = OLD.position;
END;

-- The same document at another numerics version asks for other results: it is another study.
UPDATE studies SET document_hash = '1:' || document_hash;
