package org.robonewbie.learning.environment;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/** The environments of one connection, which step in parallel, and the bytes of their requests and answers; see docs/gym-protocol.md. */
final class VectorEnvironment implements AutoCloseable {

    /** No environment. */
    static final VectorEnvironment NONE = new VectorEnvironment(List.of());

    private static final byte STEP = 1;
    private static final byte RESET = 2;
    private static final byte STEP_AND_RESET = 3;
    private static final int BYTES_BEFORE_ACTION = 1 + Long.BYTES;
    private static final byte RUNNING = 0;
    private static final byte TERMINATED = 1;
    private static final byte TRUNCATED = 2;

    private final List<TrainingEnvironment> environments;
    private final int robots;
    private final int actions;
    private final int requestBytes;
    private final int answerBytes;
    private final int observationBytes;

    private VectorEnvironment(List<TrainingEnvironment> environments) {
        this.environments = environments;
        boolean any = !environments.isEmpty();
        robots = any ? environments.get(0).robots() : 0;
        actions = any ? environments.get(0).task().joints().size() : 0;
        requestBytes = BYTES_BEFORE_ACTION + Float.BYTES * actions;
        observationBytes = any ? Float.BYTES * environments.get(0).quantities().size() : 0;
        answerBytes = observationBytes + Double.BYTES * (1 + PrivilegedState.NAMES.size()) + 1;
    }

    static VectorEnvironment of(int count, Supplier<TrainingEnvironment> environments) {
        return new VectorEnvironment(IntStream.range(0, count)
                .parallel()
                .mapToObj(i -> environments.get())
                .toList());
    }

    TrainingEnvironment environment(int index) {
        if (index < 0 || index >= environments.size()) {
            throw new IllegalArgumentException(
                    "There is no environment " + index + "; there are " + environments.size() + ", counted from 0.");
        }
        return environments.get(index);
    }

    void setOptions(DomainRandomization options) {
        environments.forEach(environment -> environment.setOptions(options));
    }

    /** Steps all environments in parallel; none of them moves if an action is not a number. */
    byte[] act(ByteBuffer request) {
        int rows = environments.size() * robots;
        if (rows == 0 || request.remaining() != rows * requestBytes) {
            throw new IllegalArgumentException("Orders of " + request.remaining() + " bytes for " + rows
                    + " robots with " + actions + " actions each; " + rows * requestBytes + " bytes were expected.");
        }
        int start = request.position();
        for (int row = 0; row < rows; row++) {
            check(request, start, row);
        }
        byte[] bytes = new byte[rows * (answerBytes + observationBytes)];
        ByteBuffer answers = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        boolean[] begun = new boolean[environments.size()];
        IntStream.range(0, environments.size()).parallel().forEach(i -> begun[i] = act(i, request, start, answers));
        return joined(bytes, begun);
    }

    private void check(ByteBuffer request, int start, int row) {
        for (int i = 0; i < actions; i++) {
            if (Float.isNaN(request.getFloat(start + row * requestBytes + BYTES_BEFORE_ACTION + i * Float.BYTES))) {
                throw new IllegalArgumentException("An action of environment " + row / robots
                        + " holds a number that is none (NaN). Was something divided by zero?");
            }
        }
    }

    /** Steps one environment, and returns whether it has been reset after that. */
    private boolean act(int index, ByteBuffer request, int start, ByteBuffer answers) {
        int first = index * robots;
        int offset = start + first * requestBytes;
        byte what = request.get(offset);
        long seed = request.getLong(offset + 1);
        TrainingEnvironment environment = environments.get(index);
        try {
            if (what == RESET) {
                environment.reset(seed);
            } else if (what == STEP || what == STEP_AND_RESET) {
                environment.act(actions(request, offset));
            }
            boolean ends = environment.isTerminated() || environment.isTruncated();
            for (int robot = 0; robot < robots; robot++) {
                write(environment, robot, answers, (first + robot) * answerBytes);
            }
            if (what == STEP_AND_RESET && ends) {
                environment.reset(seed);
                for (int robot = 0; robot < robots; robot++) {
                    int row = first + robot;
                    putFloats(
                            answers,
                            environments.size() * robots * answerBytes + row * observationBytes,
                            environment.observation(robot));
                }
            }
            return what == STEP_AND_RESET && ends;
        } catch (IllegalArgumentException wrong) {
            throw wrong;
        } catch (RuntimeException mistake) {
            throw new IllegalArgumentException(
                    "The task of environment " + index + " failed: " + mistake + " at "
                            + Arrays.stream(mistake.getStackTrace())
                                    .findFirst()
                                    .map(Object::toString)
                                    .orElse("an unknown line")
                            + ". The other environments have gone on.",
                    mistake);
        }
    }

    private double[][] actions(ByteBuffer request, int offset) {
        double[][] all = new double[robots][actions];
        for (int robot = 0; robot < robots; robot++) {
            for (int i = 0; i < actions; i++) {
                all[robot][i] = request.getFloat(offset + robot * requestBytes + BYTES_BEFORE_ACTION + i * Float.BYTES);
            }
        }
        return all;
    }

    private void write(TrainingEnvironment environment, int robot, ByteBuffer answers, int at) {
        putFloats(answers, at, environment.observation(robot));
        int next = at + observationBytes;
        answers.putDouble(next, environment.reward(robot));
        for (double number : environment.privilegedState(robot)) {
            next += Double.BYTES;
            answers.putDouble(next, number);
        }
        byte state = environment.isTerminated() ? TERMINATED : environment.isTruncated() ? TRUNCATED : RUNNING;
        answers.put(next + Double.BYTES, state);
    }

    private static void putFloats(ByteBuffer answers, int at, double... numbers) {
        for (int i = 0; i < numbers.length; i++) {
            answers.putFloat(at + i * Float.BYTES, (float) numbers[i]);
        }
    }

    /** All answers, and behind them the first observations of those that have been reset. */
    private byte[] joined(byte[] all, boolean... begun) {
        int rows = environments.size() * robots;
        int length = rows * answerBytes;
        for (int i = 0; i < begun.length; i++) {
            if (begun[i]) {
                int bytes = robots * observationBytes;
                System.arraycopy(all, rows * answerBytes + i * bytes, all, length, bytes);
                length += bytes;
            }
        }
        return Arrays.copyOf(all, length);
    }

    @Override
    public void close() {
        environments.forEach(TrainingEnvironment::close);
    }
}
