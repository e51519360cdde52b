PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE studies (
  number        INTEGER PRIMARY KEY,   -- order of submission
  id            TEXT NOT NULL UNIQUE,  -- typable: fig16a-3f9c
  name          TEXT NOT NULL,
  description   TEXT NOT NULL,
  document      TEXT NOT NULL,         -- the study as submitted, JSON
  document_hash TEXT NOT NULL UNIQUE,  -- SHA-256: the same study again is the same row
  axes          TEXT NOT NULL,         -- [{"parameter", "values"}]
  submitted_at  INTEGER NOT NULL,
  cancelled_at  INTEGER
);
INSERT INTO studies VALUES(1,'kept-8a8f','kept','of format 1','{"axes":{"Ca":[0.25,0.75],"V":[4,50,90,60]},"base":{"C":5,"fidelity":"fast","law":"skalak","shape":"biconcave","until":{"kt":30}},"description":"of format 1","name":"kept"}','8a8fe9756181eb21f82d5a0afb3b82d845fa8a2bd2397fdd63126a8ccbfae159','[{"parameter":"Ca","values":[0.25,0.75]},{"parameter":"V","values":[4,50,90,60]}]',1795535195687,NULL);
INSERT INTO studies VALUES(2,'other-58cb','other','','{"axes":{"Ca":[0.25,0.3,0.35],"V":[4,70]},"base":{"C":5,"fidelity":"fast","law":"skalak","shape":"biconcave","until":{"kt":30}},"name":"other"}','58cbe65e42d7f0ee5eaa4db22eb02657be9f507a5db0d2c092f532bbf36c5fa1','[{"parameter":"Ca","values":[0.25,0.3,0.35]},{"parameter":"V","values":[4,70]}]',1795535196213,NULL);
INSERT INTO studies VALUES(3,'dropped-78c0','dropped','','{"axes":{"Ca":[0.9],"V":[4,70]},"base":{"C":5,"fidelity":"fast","law":"skalak","shape":"biconcave","until":{"kt":30}},"name":"dropped"}','78c037dbf6c75c7d7c4b19364965ca2de9b9dc261395611785a7ce873726c86d','[{"parameter":"Ca","values":[0.9]},{"parameter":"V","values":[4,70]}]',1795535197237,1795535197255);
CREATE TABLE cases (
  number           INTEGER PRIMARY KEY,   -- the order in which cases are started
  id               TEXT NOT NULL UNIQUE,  -- content id: equal cases are one case, whichever study asks
  document         TEXT NOT NULL,         -- canonical, JSON
  state            TEXT NOT NULL DEFAULT 'queued'
                   CHECK (state IN ('queued', 'running', 'done', 'failed', 'diverged', 'cancelled')),
  message          TEXT NOT NULL DEFAULT '',   -- why the case is in this state, where that needs words
  cancel_requested INTEGER NOT NULL DEFAULT 0,
  attempt          INTEGER NOT NULL DEFAULT 0,
  crashes          INTEGER NOT NULL DEFAULT 0,
  token            TEXT,      -- of the present claim: who cannot show it may not write
  lease_until      INTEGER,
  kt               REAL NOT NULL DEFAULT 0   -- shear time reached
);
INSERT INTO cases VALUES(1,'37a6223175482b37','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.25,"V":4.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','done','',0,1,0,NULL,NULL,30.0);
INSERT INTO cases VALUES(2,'5453e560b833b098','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.25,"V":50.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','diverged','the membrane tore at kt = 0.3',0,1,0,NULL,NULL,0.0);
INSERT INTO cases VALUES(3,'336d1e25fca8fbb3','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.25,"V":90.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','failed',replace('the solver refused the case\n/V  cannot be 90','\n',char(10)),0,1,0,NULL,NULL,0.0);
INSERT INTO cases VALUES(4,'4162bae35bea7a4b','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.25,"V":60.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','failed',replace('killed by signal 6 (Aborted)\nsomething is very wrong\nsomething is very wrong','\n',char(10)),0,2,2,NULL,NULL,0.0);
INSERT INTO cases VALUES(5,'28becbe21e2a46b6','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.75,"V":4.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','done','',0,1,0,NULL,NULL,30.0);
INSERT INTO cases VALUES(6,'357ef6d94732b0b3','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.75,"V":50.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','diverged','the membrane tore at kt = 0.3',0,1,0,NULL,NULL,0.0);
INSERT INTO cases VALUES(7,'6b48b45395009039','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.75,"V":90.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','failed',replace('the solver refused the case\n/V  cannot be 90','\n',char(10)),0,1,0,NULL,NULL,0.0);
INSERT INTO cases VALUES(8,'94bcad79c1794728','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.75,"V":60.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','failed',replace('killed by signal 6 (Aborted)\nsomething is very wrong\nsomething is very wrong','\n',char(10)),0,2,2,NULL,NULL,0.0);
INSERT INTO cases VALUES(9,'127a2f6c644f1baf','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.25,"V":70.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','running','',0,1,0,'1366061477-1685133545-1975262624-3271299268',1795535256216,15.0);
INSERT INTO cases VALUES(10,'51d07c29622c2e19','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.3,"V":4.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','done','',0,1,0,NULL,NULL,30.0);
INSERT INTO cases VALUES(11,'9f1eec6c0c8804eb','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.3,"V":70.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','running','',0,1,0,'2500581189-313292291-2238863861-3113544179',1795535256267,15.0);
INSERT INTO cases VALUES(12,'fb2f659e0396d737','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.35,"V":4.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','queued','',0,0,0,NULL,NULL,0.0);
INSERT INTO cases VALUES(13,'e82b817fdb859457','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.35,"V":70.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','queued','',0,0,0,NULL,NULL,0.0);
INSERT INTO cases VALUES(14,'0af55e10c93879f5','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.9,"V":4.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','cancelled','cancelled by the user',0,0,0,NULL,NULL,0.0);
INSERT INTO cases VALUES(15,'b949f89e6b64996c','{"shape":"biconcave","law":"skalak","C":5.0,"Ca":0.9,"V":70.0,"Re":0.05,"E_b":0.0,"fluid":"quasisteady","until":{"kt":30.0,"classified":false},"fidelity":{"dx":0.2,"box":12.8,"nodes":642,"stepper":"ab2","kdt":0.08,"tolerance":0.001,"scheme":"tuned"},"outputs":{"history_every":0.1,"shapes_every":1.0,"checkpoint_every":50}}','cancelled','cancelled by the user',0,0,0,NULL,NULL,0.0);
CREATE TABLE study_cases (
  study_id TEXT NOT NULL REFERENCES studies (id),
  position INTEGER NOT NULL,
  case_id  TEXT NOT NULL REFERENCES cases (id),
  PRIMARY KEY (study_id, position)
) WITHOUT ROWID;
INSERT INTO study_cases VALUES('dropped-78c0',0,'0af55e10c93879f5');
INSERT INTO study_cases VALUES('other-58cb',1,'127a2f6c644f1baf');
INSERT INTO study_cases VALUES('kept-8a8f',4,'28becbe21e2a46b6');
INSERT INTO study_cases VALUES('kept-8a8f',2,'336d1e25fca8fbb3');
INSERT INTO study_cases VALUES('kept-8a8f',5,'357ef6d94732b0b3');
INSERT INTO study_cases VALUES('kept-8a8f',0,'37a6223175482b37');
INSERT INTO study_cases VALUES('other-58cb',0,'37a6223175482b37');
INSERT INTO study_cases VALUES('kept-8a8f',3,'4162bae35bea7a4b');
INSERT INTO study_cases VALUES('other-58cb',2,'51d07c29622c2e19');
INSERT INTO study_cases VALUES('kept-8a8f',1,'5453e560b833b098');
INSERT INTO study_cases VALUES('kept-8a8f',6,'6b48b45395009039');
INSERT INTO study_cases VALUES('kept-8a8f',7,'94bcad79c1794728');
INSERT INTO study_cases VALUES('other-58cb',3,'9f1eec6c0c8804eb');
INSERT INTO study_cases VALUES('dropped-78c0',1,'b949f89e6b64996c');
INSERT INTO study_cases VALUES('other-58cb',5,'e82b817fdb859457');
INSERT INTO study_cases VALUES('other-58cb',4,'fb2f659e0396d737');
CREATE TABLE attempts (
  case_id    TEXT NOT NULL REFERENCES cases (id),
  attempt    INTEGER NOT NULL,
  handle     TEXT NOT NULL DEFAULT '',   -- the executor's name of the run
  started_at INTEGER NOT NULL,
  ended_at   INTEGER,
  ending     TEXT,      -- done, failed, diverged, cancelled, interrupted, crashed
  reason     TEXT,
  PRIMARY KEY (case_id, attempt)
) WITHOUT ROWID;
INSERT INTO attempts VALUES('127a2f6c644f1baf',1,'16039:948404:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535196216,NULL,NULL,NULL);
INSERT INTO attempts VALUES('28becbe21e2a46b6',1,'16032:948364:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195811,1795535195839,'done','');
INSERT INTO attempts VALUES('336d1e25fca8fbb3',1,'16029:948357:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195743,1795535195788,'failed',replace('the solver refused the case\n/V  cannot be 90','\n',char(10)));
INSERT INTO attempts VALUES('357ef6d94732b0b3',1,'16033:948367:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195843,1795535195888,'diverged','the membrane tore at kt = 0.3');
INSERT INTO attempts VALUES('37a6223175482b37',1,'16027:948351:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195692,1795535195735,'done','');
INSERT INTO attempts VALUES('4162bae35bea7a4b',1,'16030:948359:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195763,1795535195790,'crashed',replace('killed by signal 6 (Aborted)\nsomething is very wrong','\n',char(10)));
INSERT INTO attempts VALUES('4162bae35bea7a4b',2,'16031:948361:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195795,1795535195836,'crashed',replace('killed by signal 6 (Aborted)\nsomething is very wrong\nsomething is very wrong','\n',char(10)));
INSERT INTO attempts VALUES('51d07c29622c2e19',1,'16040:948406:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535196235,1795535196267,'done','');
INSERT INTO attempts VALUES('5453e560b833b098',1,'16028:948353:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195711,1795535195739,'diverged','the membrane tore at kt = 0.3');
INSERT INTO attempts VALUES('6b48b45395009039',1,'16034:948369:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195864,1795535195890,'failed',replace('the solver refused the case\n/V  cannot be 90','\n',char(10)));
INSERT INTO attempts VALUES('94bcad79c1794728',1,'16035:948372:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195891,1795535195920,'crashed',replace('killed by signal 6 (Aborted)\nsomething is very wrong','\n',char(10)));
INSERT INTO attempts VALUES('94bcad79c1794728',2,'16036:948374:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535195923,1795535195939,'crashed',replace('killed by signal 6 (Aborted)\nsomething is very wrong\nsomething is very wrong','\n',char(10)));
INSERT INTO attempts VALUES('9f1eec6c0c8804eb',1,'16041:948409:7180bca8-6dc6-4fcb-9f6e-093cc7273acb',1795535196267,NULL,NULL,NULL);
CREATE TABLE results (
  case_id  TEXT PRIMARY KEY REFERENCES cases (id),
  motion   TEXT,            -- tumbling, tank_treading, transition, undecided; NULL after a numerical failure
  document TEXT NOT NULL    -- result.json
) WITHOUT ROWID;
INSERT INTO results VALUES('28becbe21e2a46b6','tank_treading','{"format":1,"stop":"reached_end","message":"","motion":"tank_treading","evidence":{"turns":2.0,"margin":0.25},"final":{"kt":30.0,"D_xy":0.5,"theta":-1.0}}');
INSERT INTO results VALUES('357ef6d94732b0b3',NULL,'{"stop":"diverged","message":"the membrane tore at kt = 0.3","motion":null}');
INSERT INTO results VALUES('37a6223175482b37','tumbling','{"format":1,"stop":"reached_end","message":"","motion":"tumbling","evidence":{"turns":2.0,"margin":0.25},"final":{"kt":30.0,"D_xy":0.5,"theta":-1.0}}');
INSERT INTO results VALUES('51d07c29622c2e19','tumbling','{"format":1,"stop":"reached_end","message":"","motion":"tumbling","evidence":{"turns":2.0,"margin":0.25},"final":{"kt":30.0,"D_xy":0.5,"theta":-1.0}}');
INSERT INTO results VALUES('5453e560b833b098',NULL,'{"stop":"diverged","message":"the membrane tore at kt = 0.3","motion":null}');
CREATE TABLE histories (
  case_id TEXT NOT NULL REFERENCES cases (id),
  record  INTEGER NOT NULL,
  kt REAL, D_xy REAL, theta REAL, psi REAL, volume REAL, area REAL,
  PRIMARY KEY (case_id, record)
) WITHOUT ROWID;
INSERT INTO histories VALUES('127a2f6c644f1baf',0,3.0,0.5,-0.10000000000000000555,0.010000000000000000208,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('127a2f6c644f1baf',1,6.0,0.5,-0.2000000000000000111,0.020000000000000000416,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('127a2f6c644f1baf',2,9.0,0.5,-0.3000000000000000444,0.029999999999999998889,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('127a2f6c644f1baf',3,12.0,0.5,-0.4000000000000000222,0.040000000000000000832,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('127a2f6c644f1baf',4,15.0,0.5,-0.5,0.050000000000000002775,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',0,3.0,0.5,-0.10000000000000000555,0.010000000000000000208,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',1,6.0,0.5,-0.2000000000000000111,0.020000000000000000416,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',2,9.0,0.5,-0.3000000000000000444,0.029999999999999998889,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',3,12.0,0.5,-0.4000000000000000222,0.040000000000000000832,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',4,15.0,0.5,-0.5,0.050000000000000002775,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',5,18.0,0.5,-0.60000000000000008881,0.059999999999999997779,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',6,21.0,0.5,-0.70000000000000006661,0.070000000000000006661,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',7,24.0,0.5,-0.8000000000000000444,0.080000000000000001665,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',8,27.0,0.5,-0.9000000000000000222,0.089999999999999996669,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('28becbe21e2a46b6',9,30.0,0.5,-1.0,0.10000000000000000555,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',0,3.0,0.5,-0.10000000000000000555,0.010000000000000000208,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',1,6.0,0.5,-0.2000000000000000111,0.020000000000000000416,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',2,9.0,0.5,-0.3000000000000000444,0.029999999999999998889,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',3,12.0,0.5,-0.4000000000000000222,0.040000000000000000832,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',4,15.0,0.5,-0.5,0.050000000000000002775,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',5,18.0,0.5,-0.60000000000000008881,0.059999999999999997779,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',6,21.0,0.5,-0.70000000000000006661,0.070000000000000006661,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',7,24.0,0.5,-0.8000000000000000444,0.080000000000000001665,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',8,27.0,0.5,-0.9000000000000000222,0.089999999999999996669,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('37a6223175482b37',9,30.0,0.5,-1.0,0.10000000000000000555,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',0,3.0,0.5,-0.10000000000000000555,0.010000000000000000208,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',1,6.0,0.5,-0.2000000000000000111,0.020000000000000000416,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',2,9.0,0.5,-0.3000000000000000444,0.029999999999999998889,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',3,12.0,0.5,-0.4000000000000000222,0.040000000000000000832,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',4,15.0,0.5,-0.5,0.050000000000000002775,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',5,18.0,0.5,-0.60000000000000008881,0.059999999999999997779,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',6,21.0,0.5,-0.70000000000000006661,0.070000000000000006661,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',7,24.0,0.5,-0.8000000000000000444,0.080000000000000001665,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',8,27.0,0.5,-0.9000000000000000222,0.089999999999999996669,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('51d07c29622c2e19',9,30.0,0.5,-1.0,0.10000000000000000555,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('9f1eec6c0c8804eb',0,3.0,0.5,-0.10000000000000000555,0.010000000000000000208,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('9f1eec6c0c8804eb',1,6.0,0.5,-0.2000000000000000111,0.020000000000000000416,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('9f1eec6c0c8804eb',2,9.0,0.5,-0.3000000000000000444,0.029999999999999998889,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('9f1eec6c0c8804eb',3,12.0,0.5,-0.4000000000000000222,0.040000000000000000832,4.1799999999999997157,17.199999999999999289);
INSERT INTO histories VALUES('9f1eec6c0c8804eb',4,15.0,0.5,-0.5,0.050000000000000002775,4.1799999999999997157,17.199999999999999289);
CREATE INDEX cases_by_state ON cases (state, number);
CREATE INDEX studies_of_a_case ON study_cases (case_id);
COMMIT;
