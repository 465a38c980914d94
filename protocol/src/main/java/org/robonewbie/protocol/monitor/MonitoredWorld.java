package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.Optional;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/**
 * The world as a monitor of any SimSpark server knows it, kept up to date message by message.
 *
 * <p>It begins with the first full message, which a server sends to each new monitor unasked. When a message does not fit
 * to what is known, the world is no longer {@link #isCurrent() current} until the next full message; {@link
 * TrainerCommand.RequestFullState} asks for one.
 *
 * <pre>{@code
 * MonitoredWorld world = new MonitoredWorld();
 * while (link.receive(message)) {
 *     world.read(message);
 *     world.ball().ifPresent(ball -> System.out.println(ball.position()));
 * }
 * }</pre>
 */
public final class MonitoredWorld {

    private static final String BALL_MESH = "soccerball.obj";

    private final SexpReader in = new SexpReader();
    private final GameStateReader gameReader = new GameStateReader(in);
    private final SceneReader sceneReader = new SceneReader(in);
    private Environment environment = Environment.UNKNOWN;
    private List<SceneNode> scene = List.of();
    private List<MonitoredRobot> robots = List.of();
    private Optional<TransformNode> ball = Optional.empty();
    private boolean current;

    /** Creates a world of which nothing is known yet. */
    public MonitoredWorld() {}

    /**
     * Takes the next message of the server. A message that cannot be understood does no harm.
     *
     * @param message the message
     * @return whether the world is current afterwards
     */
    public boolean read(MessageBuffer message) {
        in.start(message);
        try {
            readLists();
        } catch (MalformedMessageException malformed) {
            current = false;
        }
        return current;
    }

    /**
     * Tells whether the scene is known as of the last message.
     *
     * @return false before the first full message and after a message that did not fit
     */
    public boolean isCurrent() {
        return current;
    }

    /**
     * Tells the measures of pitch and rules.
     *
     * @return what the last full message said
     */
    public Environment environment() {
        return environment;
    }

    /**
     * Tells the state of the match.
     *
     * @return the newest state
     */
    public MonitoredGame gameState() {
        return gameReader.gameState();
    }

    /**
     * Lists the fouls that the last message reported.
     *
     * @return the fouls, mostly none
     */
    public List<Foul> newFouls() {
        return gameReader.fouls();
    }

    /**
     * Lists the robots that belong to a team.
     *
     * @return the robots in the order in which they connected
     */
    public List<MonitoredRobot> robots() {
        return robots;
    }

    /**
     * Finds a robot.
     *
     * @param player its team and number
     * @return the robot, or empty if it does not play
     */
    public Optional<MonitoredRobot> robot(PlayerNumber player) {
        return robots.stream().filter(robot -> robot.player().equals(player)).findFirst();
    }

    /**
     * Tells where the ball is.
     *
     * @return its place in the world frame, moving with each message; empty before it is known
     */
    public Optional<TransformNode> ball() {
        return ball;
    }

    /**
     * Shows the whole scene.
     *
     * @return the outermost nodes, as of the last full message
     */
    public List<SceneNode> scene() {
        return scene;
    }

    private void readLists() throws MalformedMessageException {
        open();
        gameReader.read();
        open();
        SceneReader.require(in.next() == Token.ATOM);
        boolean full = in.atomIs("RSG");
        SceneReader.require(full || in.atomIs("RDS"));
        in.skipTo(0);
        open();
        if (full) {
            readFullScene();
        } else if (current) {
            sceneReader.readPartial(scene);
        }
    }

    private void readFullScene() throws MalformedMessageException {
        scene = sceneReader.readFull();
        environment = gameReader.environment();
        List<TransformNode> places = scene.stream()
                .filter(node -> node instanceof TransformNode)
                .map(node -> (TransformNode) node)
                .toList();
        robots = places.stream()
                .map(MonitoredRobot::of)
                .flatMap(Optional::stream)
                .toList();
        ball = places.stream()
                .filter(place -> MonitoredMaterials.meshNames(place).anyMatch(mesh -> mesh.endsWith(BALL_MESH)))
                .findFirst();
        current = true;
    }

    private void open() throws MalformedMessageException {
        SceneReader.require(in.next() == Token.OPEN);
    }
}
