package org.robonewbie.trial;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.sensing.Camera;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.sensing.VisiblePlayer;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * A world with physics only, stepped without messages or a referee. As in a game, readings arrive one cycle late, and commands
 * are rounded to message precision and take effect in the next step.
 */
final class DirectWorld implements World {

    private final SteppedSimulator simulator;
    private final CameraSettings cameraSettings;
    private SplittableRandom random;
    private final Map<Robot, Camera> cameras = new HashMap<>();
    private Optional<WorldState> start = Optional.empty();
    private Optional<ExternalPhysics> physics = Optional.empty();
    private double[] motorSpeeds = {};
    private long cycles;

    DirectWorld(SteppedSimulator simulator, boolean noise, long seed) {
        this.simulator = simulator;
        this.cameraSettings = CameraSettings.STANDARD.withLines(false).withNoise(noise);
        this.random = new SplittableRandom(seed);
    }

    @Override
    public void cycle(List<TrialBody> bodies) {
        for (TrialBody body : bodies) {
            body.commands().forEach(command -> execute(body.robot(), command));
            body.setReadings(
                    new DirectReadings(body.robot(), this, body.controller().readsMessages()));
        }
        physics.ifPresentOrElse(this::advance, simulator.world()::step);
        cycles++;
    }

    private void advance(ExternalPhysics other) {
        SoccerWorld world = simulator.world();
        world.step(() -> other.advance(world.robots().get(0), world.ball(), motorSpeeds.clone()));
    }

    @Override
    public void setPhysics(ExternalPhysics other) {
        List<Robot> robots = simulator.world().robots();
        if (robots.size() != 1) {
            throw new IllegalArgumentException("Another physics engine simulates one robot, but this scene has "
                    + robots.size() + ". Choose a scene or a task with one.");
        }
        motorSpeeds = new double[robots.get(0).model().joints().size()];
        physics = Optional.of(other);
    }

    @Override
    public void keep() {
        start = Optional.of(simulator.world().save());
        cycles = 0;
    }

    @Override
    public void reset(long seed) {
        simulator.world().restore(start.orElseThrow());
        random = new SplittableRandom(seed);
        cameras.clear();
        physics = Optional.empty();
        cycles = 0;
    }

    private void execute(Robot robot, EffectorCommand command) {
        if (command instanceof SetHingeSpeed speed) {
            double radiansPerSecond = EffectorMessageWriter.rounded(speed.radiansPerSecond());
            robot.nao()
                    .hingeIndex(speed.effectorName())
                    .ifPresent(hinge -> setMotorSpeed(robot, hinge, radiansPerSecond));
        }
    }

    private void setMotorSpeed(Robot robot, int hinge, double radiansPerSecond) {
        if (physics.isPresent()) {
            motorSpeeds[hinge] = radiansPerSecond;
        } else {
            robot.setMotorSpeed(hinge, radiansPerSecond);
        }
    }

    double seconds() {
        return cycles * Cycle.SECONDS;
    }

    String playModeName() {
        return simulator.match().state().playMode().simSparkName();
    }

    /** Returns the camera image of this cycle; as in a game, there is an image only every third cycle. */
    Optional<Vision> picture(Robot robot) {
        if (cycles % CameraSettings.CYCLES_PER_PICTURE != 0) {
            return Optional.empty();
        }
        List<VisiblePlayer> players = new ArrayList<>();
        Optional<Player> own = Optional.empty();
        for (Player player : simulator.match().teams().players()) {
            players.add(new VisiblePlayer(player.robot(), player.team().name(), player.number()));
            own = player.robot() == robot ? Optional.of(player) : own;
        }
        Camera camera = cameras.computeIfAbsent(
                robot, key -> new Camera(simulator.world().field(), cameraSettings, random.split()));
        return Optional.of(camera.look(robot, simulator.world(), players, own.map(Player::side)));
    }
}
