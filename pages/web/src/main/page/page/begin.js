/** Starts the studio for this page's world and exposes it in the browser's console as `studio`, for tests. */
import { keep, recall } from '../panels/memory.js';
import { isClassLink } from '../state/class-link.js';
import { LAST_PROGRAM } from '../state/program/documents.js';
import { Studio } from '../studio.js';
import { AgentChoice } from './agent-choice.js';
import { addAssignment, takeAssignment } from './class-assignment.js';
import { CourseServer } from './course-server.js';
import { showBrowserAdvice } from './old-browser.js';
import { PageCompiler } from './page-compiler.js';
import { FileServer } from './file-server.js';
import { HistoryStore } from './history-store.js';
import { motionParts } from './motion-server.js';
import { answerInsteadOfServer } from './page-server.js';
import { PageRecordings } from './page-recordings.js';
import { ProgramServer } from './program-server.js';
import { ProgramRepository } from './program-repository.js';
import { addExportButtons } from './program-takeaway.js';
import { RecordingStore } from './recording-store.js';
import { addRecordingTools } from './recording-tools.js';
import { replayParts } from './replay-server.js';
import { SceneServer } from './scene-server.js';
import { NO_ROOM, storage } from './page-storage.js';
import { isShared, sharedProgram } from './share.js';
import { WorldConnection } from './world-connection.js';
import { world } from './world-process.js';
import { WorldQuestions } from './world-questions.js';

const NOT_KEPT =
  'This browser is not saving data for this page, perhaps because this is a private window. Press Download before you close the page, or your work will be lost.';

const NO_ROOM_FOR_SHARED =
  'This browser has no space left for the program in this link. Delete scenes that you do not need, then open the link again.';

/**
 * Stores the program from the page's address, if there is one.
 *
 * @param {ProgramRepository} repository
 * @returns {Promise<string>} error message, or empty
 */
async function takeShared(repository) {
  const { hash } = location;
  if (!isShared(hash)) {
    return '';
  }
  history.replaceState(undefined, '', '#program');
  try {
    const { path, text } = await sharedProgram(hash);
    keep(LAST_PROGRAM, repository.takeShared(path, text, recall(LAST_PROGRAM, '')));
    return '';
  } catch (failure) {
    const { message } = /** @type {Error} */ (failure);
    return message === NO_ROOM ? NO_ROOM_FOR_SHARED : message;
  }
}

/** @param {import('./world-process.js').World} worker */
async function begin(worker) {
  const refused = takeAssignment();
  const repository = new ProgramRepository();
  const trouble = refused || (await takeShared(repository)) || (storage().isLost ? NOT_KEPT : '');
  const options = new URLSearchParams(location.search);
  const choice = new AgentChoice(options.getAll('agent'));
  const compiler = new PageCompiler(() => worker.prepare());
  const programs = new ProgramServer(compiler, worker, repository, choice);
  const files = new FileServer(repository, new HistoryStore());
  const questions = new WorldQuestions(worker);
  const course = new CourseServer(questions, repository, programs);
  worker.ownMotions = () => files.motions;
  files.changed = () => worker.postMessage({ motions: files.motions });
  const recordings = new PageRecordings(new RecordingStore(), questions);
  const scenes = new SceneServer(questions, recordings);
  answerInsteadOfServer({
    ...files.parts,
    ...programs.parts,
    ...course.parts,
    ...motionParts(questions),
    ...scenes.parts,
    ...replayParts(recordings, questions),
  });
  const studio = new Studio(
    options,
    (listener) => new WorldConnection(worker, listener, choice, { programs, course, questions, recordings, scenes }),
  );
  Object.assign(window, { studio });
  addExportButtons(() => studio.rooms.program, repository);
  addRecordingTools(() => studio, recordings);
  studio.start();
  addAssignment();
  if (trouble) {
    studio.note(trouble);
  }
  recordings.store.full = (text) => studio.note(text);
  addEventListener('hashchange', () => (isShared(location.hash) || isClassLink(location.hash)) && location.reload());
  navigator.serviceWorker?.register('service-worker.js').catch(() => {});
}

if (world) {
  begin(world);
} else {
  showBrowserAdvice();
}
