package org.robonewbie.learning.environment;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.robonewbie.agent.policy.Policy;

/**
 * Environments of one connection, which are stepped in parallel unless the client computes the physics. Requests and responses are in
 * the binary format of docs/gym-protocol.md.
 */
final class VectorEnvironment implements AutoCloseable {

    static final VectorEnvironment NONE = new VectorEnvironment(List.of(), true);

    private static final byte STEP = 1;
    private static final byte RESET = 2;
    private static final byte STEP_AND_RESET = 3;
    private static final int BYTES_BEFORE_ACTION = 1 + Long.BYTES;
    private static final byte RUNNING = 0;
    private static final byte TERMINATED = 1;
    private static final byte TRUNCATED = 2;

    private final List<TrainingEnvironment> environments;
    private final boolean parallel;
    private Optional<Policy> policy = Optional.empty();
    private final int robots;
    private final int actions;
    private final double actionLimit;
    private final int requestBytes;
    private final int answerBytes;
    private final int observationBytes;
    private final boolean trueState;

    private VectorEnvironment(List<TrainingEnvironment> environments, boolean parallel) {
        this.environments = environments;
        this.parallel = parallel;
        boolean any = !environments.isEmpty();
        robots = any ? environments.get(0).robots() : 0;
        actions = any ? environments.get(0).task().outputs().size() : 0;
        actionLimit = any ? environments.get(0).task().actionLimit() : 1;
        requestBytes = BYTES_BEFORE_ACTION + Float.BYTES * actions;
        observationBytes = any ? Float.BYTES * environments.get(0).quantities().size() : 0;
        trueState = any && environments.get(0).hasTrueState();
        answerBytes = observationBytes
                + Double.BYTES * (1 + PrivilegedState.NAMES.size())
                + (trueState ? Float.BYTES * TrueState.QUANTITIES.size() : 0)
                + 1;
    }

    /**
     * Creates environments.
     *
     * @param environments creates the environment with a given index
     * @param parallel whether the environments are stepped in parallel
     */
    static VectorEnvironment of(int count, IntFunction<TrainingEnvironment> environments, boolean parallel) {
        return new VectorEnvironment(
                IntStream.range(0, count).parallel().mapToObj(environments).toList(), parallel);
    }

    TrainingEnvironment environment(int index) {
        if (index < 0 || index >= environments.size()) {
            throw new IllegalArgumentException("Environment " + index + " does not exist. Valid indices are 0 to "
                    + (environments.size() - 1) + ".");
        }
        return environments.get(index);
    }

    /** Sets the policy that acts in all subsequent episodes: the robot walks with its gait, if it has one. */
    void setPolicy(Policy newPolicy) {
        policy = Optional.of(newPolicy);
    }

    void setOptions(DomainRandomization options) {
        environments.forEach(environment -> environment.setOptions(options));
    }

    /** Steps all environments. If an action contains NaN, no environment is stepped. */
    byte[] act(ByteBuffer request) {
        int rows = environments.size() * robots;
        if (rows == 0 || request.remaining() != rows * requestBytes) {
            throw new IllegalArgumentException("The step request has " + request.remaining() + " bytes; expected "
                    + rows * requestBytes + " for " + rows + " robots with " + actions + " actions each.");
        }
        int start = request.position();
        for (int row = 0; row < rows; row++) {
            check(request, start, row);
        }
        IntStream indices = IntStream.range(0, environments.size());
        List<Answer> answers = (parallel ? indices.parallel() : indices)
                .mapToObj(i -> act(i, request, start + i * robots * requestBytes))
                .toList();
        ByteBuffer all = ByteBuffer.allocate(rows * answerBytes
                + answers.stream().mapToInt(answer -> answer.fresh.length).sum());
        answers.forEach(answer -> all.put(answer.states));
        answers.forEach(answer -> all.put(answer.fresh));
        return all.array();
    }

    /**
     * The response from one environment: the state of each robot, and the initial observations if it was reset after the step.
     */
    @SuppressWarnings("ArrayRecordComponent")
    private record Answer(byte[] states, byte[] fresh) {}

    private void check(ByteBuffer request, int start, int row) {
        for (int i = 0; i < actions; i++) {
            if (Float.isNaN(request.getFloat(start + row * requestBytes + BYTES_BEFORE_ACTION + i * Float.BYTES))) {
                throw new IllegalArgumentException(
                        "An action of environment " + row / robots + " contains NaN. Was something divided by zero?");
            }
        }
    }

    private Answer act(int index, ByteBuffer request, int offset) {
        byte what = request.get(offset);
        long seed = request.getLong(offset + 1);
        TrainingEnvironment environment = environments.get(index);
        try {
            if (what == RESET) {
                environment.reset(seed, policy);
            } else if (what == STEP || what == STEP_AND_RESET) {
                environment.act(actions(request, offset));
            }
            byte[] states = states(environment);
            if (what == STEP_AND_RESET && (environment.isTerminated() || environment.isTruncated())) {
                environment.reset(seed, policy);
                ByteBuffer fresh =
                        ByteBuffer.allocate(robots * observationBytes).order(ByteOrder.LITTLE_ENDIAN);
                IntStream.range(0, robots).forEach(robot -> put(fresh, environment.observation(robot)));
                return new Answer(states, fresh.array());
            }
            return new Answer(states, new byte[0]);
        } catch (IllegalArgumentException wrong) {
            throw wrong;
        } catch (RuntimeException mistake) {
            throw new IllegalArgumentException(
                    "The task of environment " + index + " failed: " + mistake + " at "
                            + Arrays.stream(mistake.getStackTrace())
                                    .findFirst()
                                    .map(Object::toString)
                                    .orElse("an unknown line")
                            + ". The other environments were stepped.",
                    mistake);
        }
    }

    private double[][] actions(ByteBuffer request, int offset) {
        double[][] all = new double[robots][actions];
        for (int robot = 0; robot < robots; robot++) {
            for (int i = 0; i < actions; i++) {
                all[robot][i] = request.getFloat(offset + robot * requestBytes + BYTES_BEFORE_ACTION + i * Float.BYTES)
                        / actionLimit;
            }
        }
        return all;
    }

    private byte[] states(TrainingEnvironment environment) {
        ByteBuffer states = ByteBuffer.allocate(robots * answerBytes).order(ByteOrder.LITTLE_ENDIAN);
        for (int robot = 0; robot < robots; robot++) {
            put(states, environment.observation(robot));
            states.putDouble(environment.reward(robot));
            for (double number : environment.privilegedState(robot)) {
                states.putDouble(number);
            }
            if (trueState) {
                for (float number : environment.trueState(robot)) {
                    states.putFloat(number);
                }
            }
            states.put(environment.isTerminated() ? TERMINATED : environment.isTruncated() ? TRUNCATED : RUNNING);
        }
        return states.array();
    }

    private static void put(ByteBuffer target, double... numbers) {
        for (double number : numbers) {
            target.putFloat((float) number);
        }
    }

    @Override
    public void close() {
        environments.forEach(TrainingEnvironment::close);
    }
}
