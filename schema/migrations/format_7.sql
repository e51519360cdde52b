-- Format 7: a case goes on from the end of a shorter run with equal steps. Cases of older programs have no such id: later
-- programs compute other steps.

ALTER TABLE cases ADD COLUMN steps_id TEXT NOT NULL DEFAULT '';
CREATE INDEX cases_to_go_on_from ON cases (steps_id, kt) WHERE state = 'done';
