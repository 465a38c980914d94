package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ProgramPlaceTest {

    private static final StackTraceElement STUDENT = call("WalkToBall", 31);
    private static final StackTraceElement JUDGE = call("org.robonewbie.exercises.Grader", 50);

    @Test
    void lineOfTheStudentIsFoundBelowTheFramework() {
        StackTraceElement[] trace = {call("org.robonewbie.agent.Robot", 9), STUDENT, JUDGE};

        assertThat(ProgramPlace.in(trace)).contains("WalkToBall.java:31");
    }

    @Test
    void whatTheJudgeDoesItselfIsNotThePrograms() {
        StackTraceElement[] trace = {call("org.robonewbie.nao.Joint", 9), JUDGE, STUDENT};

        assertThat(ProgramPlace.in(trace)).isEmpty();
    }

    @Test
    void exceptionIsDescribedWithItsLine() {
        RuntimeException thrown = new IllegalStateException("no ball");
        thrown.setStackTrace(new StackTraceElement[] {STUDENT});

        assertThat(ProgramPlace.of(thrown)).isEqualTo("java.lang.IllegalStateException: no ball in WalkToBall.java:31");
    }

    private static StackTraceElement call(String className, int line) {
        return new StackTraceElement(className, "think", className + ".java", line);
    }
}
