/** What to do instead of that which Java has and this page lacks. Pure. */

const ELSEWHERE = 'RoboNewbie on your computer has it.';

/** @type {Array<[RegExp, string]>} */
const INSTEAD = [
  [
    /class (Thread|Timer|TimerTask|ExecutorService|Executors|CompletableFuture|AtomicInteger|AtomicBoolean)\b|(package|have) java\.util\.concurrent|have java\.lang\.Thread\b/,
    `This page has no threads: let think() do a little of each behaviour, one after the other. ${ELSEWHERE}`,
  ],
  [
    /package org\.robonewbie\.(exercises|trial|simulator|learning)|class (Grader|Exercises|ExerciseCheck)\b/,
    `Programs of this page cannot start trials themselves: press Check, and change the numbers between two trials. ${ELSEWHERE}`,
  ],
  [
    /class (File|Files|Path|Paths|Scanner|FileReader|FileWriter|BufferedReader|BufferedWriter|InputStream|Socket)\b|package java\.(nio|net)|(have|for) java\.(io|nio|net)\./,
    `This page has neither files nor a keyboard for programs: log.info(...) shows what a program says. ${ELSEWHERE}`,
  ],
  [
    /package java\.time|class (Instant|Duration|LocalDate|LocalTime|Date)\b/,
    `Time on the pitch is nao.getTime(), in seconds. Dates are not in this page. ${ELSEWHERE}`,
  ],
  [/package (javax?\.swing|java\.awt)|class (JFrame|JPanel|Graphics)\b/, `This page opens no windows. ${ELSEWHERE}`],
];

/** @param {string} remark of javac, or why a program cannot run here @returns {string} what to do; empty if that is nothing that only the page lacks */
export function insteadOfMissing(remark) {
  return INSTEAD.find(([lacking]) => lacking.test(remark))?.[1] ?? '';
}
