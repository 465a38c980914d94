/** Java features that the web edition lacks, and the messages about them: the table of docs/web.md. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openWebEdition } from '../user.js';

const NO_THREADS = 'This page has no threads: let think() do a little';
const NO_FILES = 'Programs on this page cannot use files or the keyboard';
const NO_CALENDAR = 'Time on the pitch is nao.getTime(), in seconds';
const NO_TRIALS = 'Programs on this page cannot start trials';
const NO_WINDOWS = 'Programs on this page cannot open windows';
const MISSING_CLASSES = [
  ['new Thread(() -> {}).start();', NO_THREADS],
  ['new java.util.Timer();', NO_THREADS],
  ['new java.util.concurrent.atomic.AtomicInteger();', NO_THREADS],
  ['java.util.concurrent.Executors.newCachedThreadPool();', NO_THREADS],
  ['try { Thread.sleep(5); } catch (Exception e) {}', NO_THREADS],
  ['java.util.concurrent.TimeUnit.SECONDS.sleep(1);', NO_THREADS],
  ['java.nio.file.Path.of("x");', NO_FILES],
  ['new java.net.Socket();', NO_FILES],
  ['new java.io.File("x");', NO_FILES],
  ['new java.util.Scanner("x");', NO_FILES],
  ['java.time.LocalDate.now();', NO_CALENDAR],
  ['new java.util.Date();', NO_CALENDAR],
  ['new org.robonewbie.exercises.Grader();', NO_TRIALS],
  ['org.robonewbie.trial.Trial.class.getName();', NO_TRIALS],
  ['org.robonewbie.simulator.server.Simulator.class.getName();', NO_TRIALS],
  ['new javax.swing.JFrame();', NO_WINDOWS],
  ['new java.awt.Color(1);', NO_WINDOWS],
  ['java.util.EnumMap<?, ?> map = null;', 'does not provide java.util.EnumMap: use HashMap or TreeMap instead'],
  ['java.math.BigDecimal one = null;', 'does not provide java.math.BigDecimal: use double instead'],
  ['java.util.UUID.randomUUID();', 'This page does not provide java.util.UUID'],
];
const MISSING_FEATURES = [
  [
    '"a".describeConstable();',
    'The page does not provide java.lang.String.describeConstable. RoboNewbie on your computer supports this.',
  ],
  [
    'log.info(String.class.getPackageName());',
    'java.lang.Class.getPackageName is not available. The page cannot do this; RoboNewbie on your computer can.',
  ],
  [
    'log.info(getClass().getPackageName());',
    'Class.getPackageName() is not available for a class of the program. The page cannot do this',
  ],
  ['java.util.Arrays.hashCode(new int[] {1});', 'hashCode with an array of numbers or characters is not available'],
  ["String.valueOf(new char[] {'a'});", 'valueOf with an array of numbers or characters is not available'],
  [
    'new StringBuilder().append(new Letters());',
    'An object of the program cannot be passed to Java classes as a java.lang.CharSequence',
  ],
  ['log.info(String.format("%tY", 1L));', 'Unknown format conversion: t'],
  ['while (true) {}', 'Stopped at MyAgent.java:4: the program has executed 5000000 instructions'],
];

/** Returns an agent with a statement of think() in line 4. */
const agent = (statement) => `import org.robonewbie.agent.Agent;
public class MyAgent extends Agent {
    protected void think() {
        ${statement}
    }
    static class Letters implements CharSequence {
        public int length() { return 1; }
        public char charAt(int i) { return 'a'; }
        public CharSequence subSequence(int a, int b) { return this; }
    }
}
`;

/** Opens the Program room, writes a program and runs it. */
async function runs(t, text) {
  const { user } = await openWebEdition(t, { to: '#program' });
  await user.writes(text);
  await user.clicks('button', '▶ Run');
  return user;
}

slow('the compiler names a missing class and an alternative', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program' });
  for (const [statement, advice] of MISSING_CLASSES) {
    await user.writes(agent(''));
    await user.seesNo(/\d errors?, line/);

    await user.writes(agent(statement));

    const errors = await user.reads('list', 'Errors found by the compiler', advice);
    assert.match(errors, /cannot find symbol|does not exist|cannot access/, statement);
  }
});

slow('the compiler names all missing classes at once, and each of them once', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program' });
  const statements = 'Thread.sleep(5); new Thread(); EnumMap<?, ?> map; new java.util.Date();';
  await user.writes(`import java.util.EnumMap;\n${agent(statements)}`);

  await user.sees(/\b3 errors, line 1/);
  for (const advice of ['does not provide java.util.EnumMap', NO_THREADS, NO_CALENDAR]) {
    await user.reads('list', 'Errors found by the compiler', advice);
  }
});

for (const [statement, said] of MISSING_FEATURES) {
  slow(`a missing feature is reported when the program uses it: ${statement}`, async (t) => {
    const user = await runs(t, agent(statement));
    user.expectsComplaints(/^\d+\.\d\d s: /); // warnings and errors of a robot

    await user.reads('region', 'Output', said);
  });
}

slow('numbers are written with a point, whatever the locale is', async (t) => {
  const format = (number) => `String.format(java.util.Locale.GERMANY, "%.1f", ${number})`;

  const user = await runs(t, agent(`log.info("written " + ${format('1.5')} + " and " + ${format('3.0')});`));

  await user.reads('list', 'Log of the robot', 'written 1.5 and 3.0');
});

slow('a class that extends one of Java is refused before it runs', async (t) => {
  const extended = '{\n    static class Try extends java.util.ArrayList<String> {}\n';
  const user = await runs(t, agent('new Try();').replace('{\n', extended));

  await user.reads('region', 'Output', 'Try extends java.util.ArrayList, which this page does not support');
});

slow('the documented methods for arrays work', async (t) => {
  const user = await runs(
    t,
    agent(`double[] a = {3, 1}; java.util.Arrays.sort(a); int[] b = new int[2]; java.util.Arrays.fill(b, 7);
        log.info(java.util.Arrays.toString(java.util.Arrays.copyOf(a, 1)) + java.util.Arrays.toString(b)
            + java.util.Arrays.stream(a).sum() + java.util.Arrays.equals(b, b.clone())
            + java.util.Arrays.toString(java.util.Arrays.copyOfRange(b, 1, 2)));
        int[] c = {1, 2, 3}; System.arraycopy(c, 0, c, 1, 2); log.info(java.util.Arrays.toString(c));
        java.util.List<double[]> d = java.util.List.of(a); Object e = new int[2][3];
        log.info(d.get(0)[1] + " " + (e instanceof int[][]) + (e instanceof double[][]));`),
  );

  for (const line of ['[1.0][7, 7]4.0true[7]', '[1, 1, 2]', '3.0 truefalse']) {
    await user.reads('list', 'Log of the robot', line);
  }
});
