package org.robonewbie.agent.league;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robonewbie.agent.cycle.MessagePort;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.LeagueMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.JointAngles;
import org.robonewbie.protocol.perceptor.LeagueMessageReader;
import org.robonewbie.protocol.perceptor.LeaguePerception;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotModel;

/**
 * Message port through which a program for the NAO plays with another robot on RCSSServerMJ: it turns the robot's messages into those of
 * a NAO, and the commands for a NAO into those of the robot.
 */
public final class LeaguePort implements MessagePort {

    private static final double SECONDS_TO_SETTLE = LeagueMotors.SECONDS_TO_STANCE + 1;

    private final AgentLink link;
    private final MessageBuffer received;
    private final MessageBuffer answer = new MessageBuffer();
    private final RobotModel model;
    private final String team;
    private final int number;
    private final RobotRuntime robot;
    private final Diagnostics diagnostics;
    private final LeagueMessageReader reader;
    private final LeagueMessageWriter writer;
    private final LeagueMotors motors;
    private final List<SharedJoint> shared;
    private final Optional<LeagueTruth> truth;
    private boolean joined;
    private PerceptorMessage message = PerceptorMessage.NOTHING;

    /**
     * Creates the port.
     *
     * @param link the connection to the server
     * @param robot the components of the program's robot
     * @param player the robot to play with
     * @param walk its walk; empty for a robot that only stands
     * @param truth whether camera pictures include the true positions of the robot and the ball
     */
    public LeaguePort(
            AgentLink link, RobotRuntime robot, LeaguePlayer player, Optional<LearnedWalk> walk, boolean truth) {
        this.link = link;
        this.received = robot.sensors().buffer();
        this.robot = robot;
        this.model = player.model();
        this.team = player.team();
        this.number = player.number();
        this.diagnostics = robot.diagnostics();
        this.reader = new LeagueMessageReader(model, team, number);
        this.writer = new LeagueMessageWriter(answer, model);
        this.motors = new LeagueMotors(model, walk, robot.diagnostics());
        this.shared = motors.shared();
        LeagueCamera camera = new LeagueCamera(model, shared);
        robot.sensors()
                .setEquipment(
                        model.name(),
                        camera,
                        false,
                        model.equals(BoosterT1.MODEL) ? Optional.of(motors) : Optional.empty());
        this.truth = truth ? Optional.of(new LeagueTruth(camera)) : Optional.empty();
        robot.walk().setLocomotion(motors);
    }

    @Override
    public int messagesToSettle() {
        return (int) PortableMath.round(SECONDS_TO_SETTLE / Cycle.SECONDS);
    }

    @Override
    public boolean receive() throws IOException {
        if (!link.receive(received)) {
            if (!joined) {
                throw new IOException("it closed the connection. It has number " + number + " of team " + team
                        + " already (choose another --number), both teams are full, or it does not know the robot "
                        + model.name() + ".");
            }
            return false;
        }
        LeaguePerception perception = reader.read(received);
        boolean isToAgent = perception.message().seconds().isPresent(); // unlike messages to monitors
        if (!joined && isToAgent && Double.isNaN(perception.joints().degrees(0))) {
            throw new IOException("it speaks SimSpark's protocol, so it has NAOs only: leave out --robot "
                    + model.name() + ", or connect to RCSSServerMJ.");
        }
        joined = true;
        if (motors.sense(perception.joints(), torso(perception.message()))) {
            robot.sensors().falls().reset();
        }
        message = asNao(perception);
        return true;
    }

    private TorsoMotion torso(PerceptorMessage sensed) {
        TorsoMotion before = robot.sensors().torso();
        return new TorsoMotion(
                sensed.gyro().map(SimSparkFrame::toBody).orElse(before.gyro()),
                sensed.accelerometer().map(SimSparkFrame::toBody).orElse(before.acceleration()));
    }

    /** Adds the joints that the robot has in common with the NAO. */
    private PerceptorMessage asNao(LeaguePerception perception) {
        PerceptorMessage common = perception.message();
        JointAngles angles = JointAngles.of(shared.stream()
                .filter(joint -> Double.isFinite(perception.joints().degrees(joint.index())))
                .collect(Collectors.toMap(
                        SharedJoint::joint,
                        joint -> joint.toNao(perception.joints().degrees(joint.index())))));
        return new PerceptorMessage(
                common.seconds(),
                common.gameState(),
                common.heard(),
                common.gyro(),
                common.accelerometer(),
                angles,
                common.footForces(),
                common.vision()
                        .map(seen -> truth.map(known -> known.addTo(seen, perception, angles))
                                .orElse(seen)));
    }

    @Override
    public PerceptorMessage message() {
        return message;
    }

    @Override
    public void send(List<EffectorCommand> commands) throws IOException {
        answer.clear();
        if (commands.stream().anyMatch(CreateRobot.class::isInstance)) {
            writer.join(team, number);
        } else {
            motors.setFallen(robot.sensors().bodyPosition().isFallen());
            commands.forEach(this::follow);
            motors.write(writer);
        }
        link.send(answer);
    }

    private void follow(EffectorCommand command) {
        if (command instanceof SetHingeSpeed hinge) {
            double speed = PortableMath.toDegrees(hinge.radiansPerSecond());
            if (!motors.setSpeed(hinge.effectorName(), speed)) {
                diagnostics.reportAt("", "league legs", () -> ignored(hinge.effectorName()));
            }
        } else if (command instanceof Beam beam && robot.sensors().isBeamAllowed()) {
            writer.beam(onServer(beam.pose()));
            motors.placed();
        } else if (command instanceof Say say) {
            say(say.text());
        }
    }

    /** Converts a pose in the team's frame. The server turns the heading of the right team, but only mirrors its x axis. */
    private Pose2d onServer(Pose2d pose) {
        return robot.sensors().side() == TeamSide.LEFT ? pose : new Pose2d(pose.x(), -pose.y(), pose.degrees());
    }

    private void say(String text) {
        try {
            writer.say(text);
        } catch (IllegalArgumentException tooLong) {
            diagnostics.reportAt("", "league say", () -> String.valueOf(tooLong.getMessage()));
        }
    }

    private String ignored(String effectorName) {
        Optional<Joint> joint = Joint.ofEffector(effectorName);
        return "The " + model.name() + " stands and walks by itself: commands and motions for its legs are ignored ("
                + joint.map(Joint::name).orElse(effectorName) + ").";
    }

    @Override
    public boolean isLate() throws IOException {
        return link.isMessageWaiting();
    }

    @Override
    public void close() {
        link.close();
    }
}
