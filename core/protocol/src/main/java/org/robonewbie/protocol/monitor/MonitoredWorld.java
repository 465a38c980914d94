package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.Optional;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/**
 * A monitor's model of the world, updated by messages from any SimSpark server, or from RCSSServerMJ: the first message that is
 * understood decides which. Of RCSSServerMJ, robots and ball are in {@link #rsmp()}, and here only what both have.
 *
 * <p>It is initialised by the first full message, which a server sends to each new monitor. After a partial message that does
 * not match the scene, the world is no longer {@link #isCurrent() current} until the next full message. Send {@link
 * Order.RequestFullState} to request one.
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
    private Optional<RsmpWorld> rsmp = Optional.empty();

    /** Creates an empty world. */
    public MonitoredWorld() {}

    /**
     * Applies the next message from the server. Malformed messages are ignored.
     *
     * @param message the message
     * @return whether the world is current afterwards
     */
    public boolean read(MessageBuffer message) {
        if (rsmp.isEmpty() && !current && RsmpWorld.isRsmp(message)) {
            rsmp = Optional.of(new RsmpWorld());
        }
        if (rsmp.isPresent()) {
            return rsmp.get().read(message);
        }
        in.start(message);
        try {
            readLists();
        } catch (MalformedMessageException malformed) {
            current = false;
        }
        return current;
    }

    /** {@return the world of a server that speaks RSMP, as its first message showed; empty for a SimSpark server} */
    public Optional<RsmpWorld> rsmp() {
        return rsmp;
    }

    /**
     * {@return whether the scene is up to date; false before the first full message and after a partial message that did not
     * match the scene}
     */
    public boolean isCurrent() {
        return rsmp.map(RsmpWorld::isCurrent).orElse(current);
    }

    /** {@return dimensions of the pitch and parameters of the rules, as of the last full message} */
    public Environment environment() {
        return rsmp.map(RsmpWorld::environment).orElse(environment);
    }

    /** {@return the latest state of the match} */
    public MonitoredGame gameState() {
        return rsmp.map(RsmpWorld::gameState).orElseGet(gameReader::gameState);
    }

    /** {@return the fouls in the last message, usually none} */
    public List<Foul> newFouls() {
        return rsmp.map(RsmpWorld::newFouls).orElseGet(gameReader::fouls);
    }

    /** {@return the robots that have joined a team, in the order in which they connected} */
    public List<MonitoredRobot> robots() {
        return robots;
    }

    /**
     * Returns a robot.
     *
     * @param player the robot's team and number
     * @return the robot; empty if it is not in the scene
     */
    public Optional<MonitoredRobot> robot(PlayerNumber player) {
        return robots.stream().filter(robot -> robot.player().equals(player)).findFirst();
    }

    /** {@return the ball's transform in the world frame, updated with each message; empty if the scene has no ball} */
    public Optional<TransformNode> ball() {
        return ball;
    }

    /** {@return the top-level nodes of the scene, as of the last full message} */
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
        List<TransformNode> transforms = scene.stream()
                .filter(node -> node instanceof TransformNode)
                .map(node -> (TransformNode) node)
                .toList();
        robots = transforms.stream()
                .map(MonitoredRobot::of)
                .flatMap(Optional::stream)
                .toList();
        ball = transforms.stream()
                .filter(transform -> transform.meshFiles().anyMatch(mesh -> mesh.endsWith(BALL_MESH)))
                .findFirst();
        current = true;
    }

    private void open() throws MalformedMessageException {
        SceneReader.require(in.next() == Token.OPEN);
    }
}
