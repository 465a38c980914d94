package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.running.StackSample.Kind;

class StackSampleTest {

    private static final StackTraceElement STUDENT = new StackTraceElement("Waiter", "think", "Waiter.java", 9);
    private static final StackTraceElement CYCLE = call("org.robonewbie.agent.Agent", "run", 150);

    static Stream<Arguments> waysToWait() {
        return Stream.of(
                arguments(Kind.SLEEPS, "Thread.sleep()", Thread.State.TIMED_WAITING, new StackTraceElement[] {
                    nativeCall("java.lang.Thread", "sleep"), STUDENT, CYCLE
                }),
                arguments(Kind.SLEEPS, "TimeUnit.sleep()", Thread.State.TIMED_WAITING, new StackTraceElement[] {
                    nativeCall("java.lang.Thread", "sleep"),
                    call("java.util.concurrent.TimeUnit", "sleep", 386),
                    STUDENT,
                    CYCLE
                }),
                arguments(Kind.SLEEPS, "LockSupport.parkNanos()", Thread.State.TIMED_WAITING, new StackTraceElement[] {
                    nativeCall("jdk.internal.misc.Unsafe", "park"),
                    call("java.util.concurrent.locks.LockSupport", "parkNanos", 410),
                    STUDENT,
                    CYCLE
                }),
                arguments(Kind.WAITS, "Object.wait()", Thread.State.WAITING, new StackTraceElement[] {
                    nativeCall("java.lang.Object", "wait"), call("java.lang.Object", "wait", 338), STUDENT, CYCLE
                }),
                arguments(Kind.WAITS, "Thread.join()", Thread.State.WAITING, new StackTraceElement[] {
                    nativeCall("java.lang.Object", "wait"), call("java.lang.Thread", "join", 1304), STUDENT, CYCLE
                }),
                arguments(Kind.WAITS, "synchronized", Thread.State.BLOCKED, new StackTraceElement[] {STUDENT, CYCLE}),
                arguments(Kind.WAITS, "Scanner.nextLine()", Thread.State.RUNNABLE, new StackTraceElement[] {
                    nativeCall("java.io.FileInputStream", "readBytes"),
                    call("java.io.BufferedInputStream", "read", 263),
                    call("java.util.Scanner", "nextLine", 1651),
                    STUDENT,
                    CYCLE
                }),
                arguments(
                        Kind.WAITS, "Socket$SocketInputStream.read()", Thread.State.RUNNABLE, new StackTraceElement[] {
                            nativeCall("sun.nio.ch.Net", "poll"),
                            call("java.net.Socket$SocketInputStream", "read", 976),
                            STUDENT,
                            CYCLE
                        }));
    }

    @ParameterizedTest
    @MethodSource("waysToWait")
    void knowsWhatTheProgramWaitsIn(Kind kind, String call, Thread.State state, StackTraceElement[] trace) {
        assertThat(StackSample.of(state, trace))
                .isEqualTo(new StackSample(kind, call.replace('$', '.'), "Waiter.java:9"));
    }

    @Test
    void aProgramThatWorksComputes() {
        StackTraceElement[] trace = {call("java.util.ArrayList", "sort", 1), STUDENT, CYCLE};

        assertThat(StackSample.of(Thread.State.RUNNABLE, trace))
                .isEqualTo(new StackSample(Kind.COMPUTES, "", "Waiter.java:9"));
    }

    @Test
    void aFrameworkThatWaitsForTheSimulatorIsNotTheProgramsFault() {
        StackTraceElement[] trace = {
            nativeCall("java.lang.Object", "wait"), call("org.robonewbie.agent.Nao", "sense", 90), STUDENT
        };

        assertThat(StackSample.of(Thread.State.WAITING, trace).kind()).isEqualTo(Kind.COMPUTES);
    }

    @Test
    void aThreadThatHasEndedHasNoPlace() {
        assertThat(StackSample.of(Thread.State.TERMINATED, new StackTraceElement[0]))
                .isEqualTo(new StackSample(Kind.COMPUTES, "", ""));
    }

    private static StackTraceElement call(String type, String method, int line) {
        return new StackTraceElement(type, method, type + ".java", line);
    }

    private static StackTraceElement nativeCall(String type, String method) {
        return new StackTraceElement(type, method, type + ".java", -2);
    }
}
