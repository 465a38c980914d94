package org.robonewbie.trial.batch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ThreadRunnerTest {

    private static final List<Integer> HUNDRED = IntStream.range(0, 100).boxed().toList();

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void resultsAreInTheOrderOfTheJobs(int threads) throws IOException {
        try (BatchRunner runner = new ThreadRunner(threads)) {
            assertThat(runner.run(HUNDRED, x -> x * x))
                    .isEqualTo(HUNDRED.stream().map(x -> x * x).toList());
        }
    }

    @Test
    void jobsRunAtTheSameTime() throws IOException {
        CountDownLatch both = new CountDownLatch(2);

        try (BatchRunner runner = new ThreadRunner(2)) {
            List<Boolean> met = runner.run(List.of(1, 2), x -> {
                both.countDown();
                both.await();
                return true;
            });

            assertThat(met).containsOnly(true);
        }
    }

    @Test
    void resultsArePassedOnAsTheyComeInTheThreadOfTheCaller() throws IOException {
        CountDownLatch second = new CountDownLatch(1);
        List<String> received = new ArrayList<>();
        Thread caller = Thread.currentThread();

        try (BatchRunner runner = new ThreadRunner(2)) {
            runner.run(
                    List.of(1, 2),
                    x -> {
                        if (x == 1) {
                            second.await();
                        }
                        return 10 * x;
                    },
                    (x, result) -> {
                        received.add(x + ": " + result + " " + (Thread.currentThread() == caller));
                        second.countDown();
                    });
        }

        assertThat(received).containsExactly("2: 20 true", "1: 10 true");
    }

    @Test
    void firstFailureEndsTheBatch() throws IOException {
        List<Integer> received = new ArrayList<>();

        try (BatchRunner runner = new ThreadRunner(1)) {
            assertThatThrownBy(() -> runner.run(HUNDRED, ThreadRunnerTest::failsAtThree, (x, y) -> received.add(x)))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("three");
            assertThat(runner.run(List.of(1), ThreadRunnerTest::failsAtThree)).containsExactly(1);
        }

        assertThat(received).containsExactly(0, 1, 2);
    }

    private static int failsAtThree(int x) {
        if (x == 3) {
            throw new IllegalArgumentException("three");
        }
        return x;
    }

    @Test
    void failureOfTheReceiverEndsTheBatch() {
        try (BatchRunner runner = new ThreadRunner(2)) {
            assertThatThrownBy(() -> runner.run(HUNDRED, x -> x, (x, y) -> {
                        throw new IOException("disk full");
                    }))
                    .isInstanceOf(IOException.class)
                    .hasMessage("disk full");
        }
    }

    @Test
    void checkedExceptionsAndErrorsKeepTheirMessage() {
        try (BatchRunner runner = new ThreadRunner(1)) {
            assertThatThrownBy(() -> runner.run(List.of(1), x -> {
                        throw new IOException("no file");
                    }))
                    .isInstanceOf(IOException.class)
                    .hasMessage("no file");
            assertThatThrownBy(() -> runner.run(List.of(1), x -> {
                        throw new ReflectiveOperationException("no class");
                    }))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("no class");
            assertThatThrownBy(() -> runner.run(List.of(1), x -> {
                        throw new StackOverflowError("deep");
                    }))
                    .isInstanceOf(StackOverflowError.class);
        }
    }

    @Test
    void interruptedCallerStopsItsJobs() throws Exception {
        CountDownLatch started = new CountDownLatch(1);
        CountDownLatch stopped = new CountDownLatch(1);
        FutureTask<List<Integer>> task = new FutureTask<>(() -> {
            try (BatchRunner runner = new ThreadRunner(1)) {
                return runner.run(List.of(1), x -> {
                    started.countDown();
                    try {
                        new CountDownLatch(1).await();
                    } finally {
                        stopped.countDown();
                    }
                    return x;
                });
            }
        });
        Thread caller = new Thread(task);
        caller.start();
        started.await();

        caller.interrupt();

        assertThatThrownBy(task::get)
                .isInstanceOf(ExecutionException.class)
                .hasRootCauseInstanceOf(InterruptedException.class)
                .hasMessageContaining("The run was interrupted.");
        stopped.await();
    }

    @Test
    void usesAllProcessorsByDefault() throws IOException {
        try (BatchRunner runner = new ThreadRunner()) {
            assertThat(runner.label()).isEqualTo("local");
            assertThat(runner.run(List.<Integer>of(), x -> x)).isEmpty();
        }
    }
}
