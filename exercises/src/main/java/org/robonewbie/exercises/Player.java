package org.robonewbie.exercises;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.world.Robot;

/** A robot on a {@link Stage}: its program on one side, and on the other what is true of its body. */
public final class Player {

    private static final double TORSO_METRES = 0.39;
    private static final double FALLEN = 0.5;
    private static final double STANDING = 0.9;
    private static final double LOWEST_STANDING_TORSO = 0.25;

    private final AgentLink link;
    private final MessageBuffer received = new MessageBuffer();
    private final MessageBuffer answer = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(answer);
    private final Robot robot;
    private Program program;
    private List<EffectorCommand> commands = List.of();

    /** Creates a robot that has been let in and has just received its first message. */
    Player(AgentLink link, Robot robot, Program program) throws IOException {
        this.link = link;
        this.robot = robot;
        this.program = program;
        receive();
    }

    static void create(AgentLink link) throws IOException {
        MessageBuffer first = new MessageBuffer();
        EffectorMessageWriter writer = new EffectorMessageWriter(first);
        writer.createRobot("rsg/agent/nao/nao.rsg", List.of());
        writer.synchronise();
        link.send(first);
    }

    void join(String team, int number) throws IOException {
        writer.joinTeam(number, team);
        send();
    }

    void idle() throws IOException {
        send();
    }

    void listen() throws IOException {
        receive();
    }

    /** Lets the program answer the last message. */
    void think() throws IOException {
        commands = program.respond(received);
        for (EffectorCommand command : commands) {
            if (!(command instanceof EffectorCommand.Synchronise) && !(command instanceof EffectorCommand.Beam)) {
                writer.write(command);
            }
        }
        send();
    }

    /** Shows the program what the robot senses; what it does then does not count. */
    void awake() {
        program.awake(received);
    }

    void handOverTo(Program other) {
        program = other;
    }

    void close() {
        link.close();
        program.close();
    }

    /**
     * Puts the robot upright somewhere else, with its joints as they are.
     *
     * @param place where to
     */
    public void moveTo(Place place) {
        robot.moveUpright(new Vector3(place.x(), place.y(), TORSO_METRES), place.degrees() - 90);
        robot.wake();
    }

    /**
     * Tells where the robot truly stands.
     *
     * @return place of the torso
     */
    public Place place() {
        Vector3 torso = torso();
        Vector3 forward = robot.torso().rotation().axisY();
        return new Place(torso.x(), torso.y(), Math.toDegrees(Math.atan2(forward.y(), forward.x())));
    }

    /**
     * Tells where the robot's torso truly is.
     *
     * @return its centre in metres
     */
    public Vector3 torso() {
        return robot.torso().position();
    }

    /**
     * Tells how a joint truly stands.
     *
     * @param joint a joint
     * @return degrees
     */
    public double jointDegrees(Joint joint) {
        return robot.jointDegrees(joint);
    }

    /**
     * Tells where something truly is, as seen from the robot.
     *
     * @param point a point of the pitch
     * @return degrees to the left of where the torso looks, -180 to 180
     */
    public double bearing(Vector3 point) {
        Place here = place();
        double direction = Math.toDegrees(Math.atan2(point.y() - here.y(), point.x() - here.x()));
        return Math.IEEEremainder(direction - here.degrees(), 360);
    }

    /**
     * Tells how far something truly is.
     *
     * @param point a point of the pitch
     * @return metres along the ground from the torso
     */
    public double distance(Vector3 point) {
        return Math.hypot(point.x() - torso().x(), point.y() - torso().y());
    }

    /**
     * Tells whether the robot truly lies.
     *
     * @return whether its torso is tilted by more than 60 degrees
     */
    public boolean isFallen() {
        return robot.torso().rotation().zz() < FALLEN;
    }

    /**
     * Tells whether the robot truly stands on its feet.
     *
     * @return whether its torso is upright and high
     */
    public boolean isStanding() {
        return robot.torso().rotation().zz() > STANDING && torso().z() > LOWEST_STANDING_TORSO;
    }

    /**
     * Tells what the robot has said in this cycle.
     *
     * @return the text; empty if it was silent
     */
    public Optional<String> said() {
        return commands.stream()
                .filter(EffectorCommand.Say.class::isInstance)
                .map(say -> ((EffectorCommand.Say) say).text())
                .findFirst();
    }

    private void send() throws IOException {
        writer.synchronise();
        link.send(answer);
        answer.clear();
    }

    private void receive() throws IOException {
        if (!link.receive(received)) {
            throw new IllegalStateException("The simulator has sent a robot of the exercise away.");
        }
    }
}
