package org.robonewbie.simulator.server;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.monitor.MonitorSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * The configuration of a simulator.
 *
 * <pre>{@code
 * SimulatorSettings settings =
 *         SimulatorSettings.league().agentPort(0).synchronous(true).build();
 * }</pre>
 *
 * @param world pitch, rules, noise and seed
 * @param bindAddress address of this computer at which agents may connect; 127.0.0.1 for this computer only
 * @param agentPort TCP port for agents, 0 for any free one
 * @param doors a door for each team instead of the port for all; none for that port
 * @param speed simulated seconds per second, or {@link SimulationControl#AS_FAST_AS_POSSIBLE}
 * @param awaitedAgents how many agents must have spoken before the first cycle, 0 not to wait
 * @param silentAgentSeconds real seconds after which an agent of another process that keeps the world waiting is dropped
 * @param seconds simulated seconds after which the simulation ends; empty runs until it is closed
 * @param recording file for the recording
 * @param report file for the report
 * @param monitorPort TCP port for monitors and trainers, 0 for any free one; empty opens none
 * @param monitorStepSeconds simulated seconds between two messages to monitors
 * @param trainers whether monitors may change the world
 * @param monitorLog file for a log that RoboViz can replay
 */
public record SimulatorSettings(
        WorldSettings world,
        String bindAddress,
        int agentPort,
        List<TeamDoor> doors,
        double speed,
        int awaitedAgents,
        double silentAgentSeconds,
        OptionalDouble seconds,
        Optional<Path> recording,
        Optional<Path> report,
        OptionalInt monitorPort,
        double monitorStepSeconds,
        boolean trainers,
        Optional<Path> monitorLog) {

    /** Makes the list unmodifiable. */
    public SimulatorSettings {
        doors = List.copyOf(doors);
    }

    /** The port of the league. */
    public static final int DEFAULT_AGENT_PORT = 3100;

    /** The port at which monitors look for a server. */
    public static final int DEFAULT_MONITOR_PORT = 3200;

    /** Real seconds for which an agent of another process may keep the world waiting. */
    public static final double DEFAULT_SILENT_AGENT_SECONDS = 60;

    /**
     * Begins with settings like those of rcssserver3d: port 3100, real time, rules and noise of the league.
     *
     * @return a builder
     */
    public static Builder league() {
        return new Builder(WorldSettings.league());
    }

    /**
     * Begins with the beginners' pitch and rules; the rest is as in the league.
     *
     * @return a builder
     */
    public static Builder beginner() {
        return new Builder(WorldSettings.beginner());
    }

    /** Collects settings; what is not set keeps its usual value. */
    public static final class Builder {

        private WorldSettings world;
        private String bindAddress = "127.0.0.1";
        private int agentPort = DEFAULT_AGENT_PORT;
        private List<TeamDoor> doors = List.of();
        private double speed = 1;
        private int awaitedAgents;
        private double silentAgentSeconds = DEFAULT_SILENT_AGENT_SECONDS;
        private OptionalDouble seconds = OptionalDouble.empty();
        private Optional<Path> recording = Optional.empty();
        private Optional<Path> report = Optional.empty();
        private OptionalInt monitorPort = OptionalInt.empty();
        private double monitorStepSeconds = MonitorSettings.STANDARD_STEP_SECONDS;
        private boolean trainers = true;
        private Optional<Path> monitorLog = Optional.empty();

        private Builder(WorldSettings world) {
            this.world = world.withSynchronous(false);
        }

        /**
         * Sets pitch and rules.
         *
         * @param value the parameters
         * @return this builder
         */
        public Builder parameters(SoccerParameters value) {
            world = world.withParameters(value);
            return this;
        }

        /**
         * Sets who may connect.
         *
         * @param value address of this computer, such as 127.0.0.1 or 0.0.0.0
         * @return this builder
         */
        public Builder bindAddress(String value) {
            bindAddress = value;
            return this;
        }

        /**
         * Sets the port.
         *
         * @param value TCP port, 0 for any free one
         * @return this builder
         */
        public Builder agentPort(int value) {
            agentPort = value;
            return this;
        }

        /**
         * Lets each team in through a door of its own and nobody else; the agent port stays closed.
         *
         * @param value the doors
         * @return this
         */
        public Builder doors(List<TeamDoor> value) {
            doors = List.copyOf(value);
            return this;
        }

        /**
         * Sets whether the world waits for the agents.
         *
         * @param value whether it does
         * @return this builder
         */
        public Builder synchronous(boolean value) {
            world = world.withSynchronous(value);
            return this;
        }

        /**
         * Sets the speed at the start.
         *
         * @param value simulated seconds per second, or {@link SimulationControl#AS_FAST_AS_POSSIBLE}
         * @return this builder
         */
        public Builder speed(double value) {
            speed = value;
            return this;
        }

        /**
         * Sets whether robots see with noise.
         *
         * @param value whether they do
         * @return this builder
         */
        public Builder noise(boolean value) {
            world = world.withNoise(value);
            return this;
        }

        /**
         * Sets which true values robots receive that no camera could know, for experiments: {@code mypos}, {@code myorien} and
         * {@code ballpos}.
         *
         * @param ownPosition whether each picture has the true position of the robot's head
         * @param ownOrientation whether it has the true direction of the robot's head
         * @param ballPosition whether it has the true position of the ball
         * @return this builder
         */
        public Builder groundTruth(boolean ownPosition, boolean ownOrientation, boolean ballPosition) {
            world = world.withCamera(world.camera().withTruth(ownPosition, ownOrientation, ballPosition));
            return this;
        }

        /**
         * Sets whether robots receive what they cannot know, for experiments.
         *
         * @param value whether the camera also reports the true positions of its robot and the ball
         * @return this builder
         */
        public Builder truth(boolean value) {
            return groundTruth(value, value, value);
        }

        /**
         * Sets what stands on the pitch.
         *
         * @param value the landscape
         * @return this builder
         */
        public Builder landscape(Landscape value) {
            world = world.withLandscape(value);
            return this;
        }

        /**
         * Sets the start of all random numbers.
         *
         * @param value any number
         * @return this builder
         */
        public Builder seed(long value) {
            world = world.withSeed(value);
            return this;
        }

        /**
         * Sets how many agents are awaited.
         *
         * @param value how many must have spoken before the first cycle, 0 not to wait
         * @return this builder
         */
        public Builder awaitedAgents(int value) {
            awaitedAgents = value;
            return this;
        }

        /**
         * Sets how long a silent agent may hold the world up.
         *
         * @param value real seconds
         * @return this builder
         */
        public Builder silentAgentSeconds(double value) {
            silentAgentSeconds = value;
            return this;
        }

        /**
         * Sets when the simulation ends.
         *
         * @param value simulated seconds, or empty to run until it is closed
         * @return this builder
         */
        public Builder seconds(OptionalDouble value) {
            seconds = value;
            return this;
        }

        /**
         * Sets where the recording is written.
         *
         * @param value the file, or empty for none
         * @return this builder
         */
        public Builder recording(Optional<Path> value) {
            recording = value;
            return this;
        }

        /**
         * Sets where the report is written.
         *
         * @param value the file, or empty for none
         * @return this builder
         */
        public Builder report(Optional<Path> value) {
            report = value;
            return this;
        }

        /**
         * Sets where monitors and trainers can connect.
         *
         * @param value TCP port, 0 for any free one, or empty for none
         * @return this builder
         */
        public Builder monitorPort(OptionalInt value) {
            monitorPort = value;
            return this;
        }

        /**
         * Sets how often monitors receive messages.
         *
         * @param value simulated seconds between two messages, at least 0.02
         * @return this builder
         */
        public Builder monitorStepSeconds(double value) {
            monitorStepSeconds = value;
            return this;
        }

        /**
         * Sets whether monitors may change the world, as trainers do, or only watch.
         *
         * @param value whether orders are carried out; usual is yes
         * @return this
         */
        public Builder trainers(boolean value) {
            trainers = value;
            return this;
        }

        /**
         * Sets where the log for RoboViz is written.
         *
         * @param value the file, or empty for none
         * @return this builder
         */
        public Builder monitorLog(Optional<Path> value) {
            monitorLog = value;
            return this;
        }

        /**
         * Finishes the settings.
         *
         * @return the settings
         */
        public SimulatorSettings build() {
            return new SimulatorSettings(
                    world,
                    bindAddress,
                    agentPort,
                    doors,
                    speed,
                    awaitedAgents,
                    silentAgentSeconds,
                    seconds,
                    recording,
                    report,
                    monitorPort,
                    monitorStepSeconds,
                    trainers,
                    monitorLog);
        }
    }
}
