package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/**
 * A monitor's model of the world, updated by messages in RSMP 1.0, the monitor protocol of RCSSServerMJ.
 *
 * <p>The server sends a full message to each new monitor, after each join of a robot and every five seconds, and changes in between.
 * A change of less than 0.005 in each element of a transform is not sent, so that poses lag behind by up to 5 mm and 0.3° per joint.
 *
 * <p>A message that is not understood is named by {@link #problem()}, and the world is not {@link #isCurrent() current} until the
 * next full message.
 *
 * <p>Source of the format: {@code remote_monitor.py} and {@code state_info.py} of rcsssmj 0.2.1.
 */
public final class RsmpWorld {

    private static final int MAJOR_VERSION = 1;
    private static final int MAX_VERSION = 10_000;
    private static final int MAX_ROBOTS = 100;
    private static final int MAX_PLAYER_NUMBER = 1000;

    private final SexpReader in = new SexpReader();
    private final RsmpWords words = new RsmpWords(in);
    private final RsmpSceneReader sceneReader = new RsmpSceneReader(in, words);
    private final RsmpGameReader gameReader = new RsmpGameReader(in, words);
    private final Map<PlayerNumber, RsmpFigure> figures = new HashMap<>();
    private Optional<RsmpNode> scene = Optional.empty();
    private List<Placed> robots = List.of();
    private List<RsmpNode> ball = List.of();
    private double seconds;
    private long messages;
    private boolean current;
    private Optional<Problem> problem = Optional.empty();

    /**
     * Why a message was not understood.
     *
     * @param message number of the message since the first one, from 1
     * @param reason what is wrong, with the word that was not understood
     */
    public record Problem(long message, String reason) {

        /** {@return the problem as a sentence} */
        @Override
        public String toString() {
            return "Message " + message + ": " + reason + ".";
        }
    }

    /** A robot of the scene: who it is, the nodes from the root to its torso's parent, and its figure. */
    private record Placed(PlayerNumber player, List<RsmpNode> path, RsmpFigure figure) {}

    /** Creates an empty world. */
    public RsmpWorld() {}

    /**
     * Returns whether a message is written in RSMP, of whatever version.
     *
     * @param message the message
     * @return whether it starts with {@code ((RSMP}
     */
    public static boolean isRsmp(MessageBuffer message) {
        SexpReader reader = new SexpReader();
        reader.start(message);
        return reader.next() == Token.OPEN && reader.nextList(1) && reader.atomIs("RSMP");
    }

    /**
     * Applies the next message from the server.
     *
     * @param message the message
     * @return whether the world is current afterwards
     */
    public boolean read(MessageBuffer message) {
        messages++;
        in.start(message);
        gameReader.start();
        try {
            readMessage();
            problem = Optional.empty();
        } catch (MalformedMessageException malformed) {
            current = false;
            problem = Optional.of(new Problem(messages, String.valueOf(malformed.getMessage())));
        }
        return current;
    }

    /** {@return whether the scene is up to date; false before the first full message and after a message that was not understood} */
    public boolean isCurrent() {
        return current;
    }

    /** {@return why the last message was not understood; empty if it was} */
    public Optional<Problem> problem() {
        return problem;
    }

    /** {@return the time since the server's start in seconds} */
    public double seconds() {
        return seconds;
    }

    /** {@return dimensions of the pitch and parameters of the rules, as of the last full message} */
    public Environment environment() {
        return gameReader.environment();
    }

    /** {@return the latest state of the match} */
    public MonitoredGame gameState() {
        return gameReader.gameState();
    }

    /** {@return the fouls in the last message; the server sends those of every second cycle only} */
    public List<Foul> newFouls() {
        return gameReader.fouls();
    }

    /** {@return pose of the ball in the world frame; empty if the scene has no ball} */
    public Optional<Pose> ball() {
        return ball.isEmpty() ? Optional.empty() : Optional.of(pose(ball));
    }

    /** {@return the robots, in the order in which they joined} */
    public List<RsmpRobot> robots() {
        return robots.stream()
                .map(robot -> new RsmpRobot(robot.player(), robot.figure().state(pose(robot.path()))))
                .toList();
    }

    private static Pose pose(List<RsmpNode> path) {
        Pose pose = Pose.ORIGIN;
        for (RsmpNode node : path) {
            pose = pose.times(node.pose());
        }
        return pose;
    }

    private void readMessage() throws MalformedMessageException {
        words.open();
        readVersion("RSMP");
        boolean changed = false;
        while (in.next() == Token.OPEN) {
            changed |= readPart();
        }
        if (in.token() != Token.CLOSE) {
            throw words.unexpected("a part \"((NAME VERSION) …)\" or \")\"");
        }
        if (in.next() != Token.END) {
            throw words.unexpected("the end of the message");
        }
        if (changed) {
            findThings();
        }
    }

    /** Reads a part after its opening parenthesis; returns whether it replaced the scene. Parts of unknown names are skipped. */
    private boolean readPart() throws MalformedMessageException {
        int outside = in.depth() - 1;
        words.open();
        String name = words.word("the name of a part");
        switch (name) {
            case "gt" -> {
                requireVersion(name);
                seconds = words.number("the time");
                words.close();
            }
            case "sg" -> {
                requireVersion(name);
                return readScene();
            }
            case "gs" -> {
                requireVersion(name);
                gameReader.readState();
            }
            case "ge" -> {
                requireVersion(name);
                gameReader.readEnvironment();
            }
            default -> in.skipTo(outside);
        }
        return false;
    }

    private boolean readScene() throws MalformedMessageException {
        String kind = words.word("\"full\" or \"diff\"");
        boolean full = kind.equals("full");
        if (full) {
            current = false;
            scene = Optional.of(sceneReader.readFull());
        } else if (!kind.equals("diff")) {
            throw words.unexpected("\"full\" or \"diff\"");
        } else if (current && scene.isPresent()) {
            sceneReader.readChanges(scene.get());
        } else {
            in.skipTo(in.depth() - 1);
            return false;
        }
        words.close();
        return full;
    }

    private void readVersion(String name) throws MalformedMessageException {
        words.open();
        if (!words.word("\"" + name + "\"").equals(name)) {
            throw words.unexpected("\"" + name + "\"");
        }
        requireVersion(name);
    }

    /** Reads major and minor version after the name. Any minor version is accepted; it may only add entries. */
    private void requireVersion(String name) throws MalformedMessageException {
        int major = words.integer("the version of \"" + name + "\"", 0, MAX_VERSION);
        int minor = words.integer("the version of \"" + name + "\"", 0, MAX_VERSION);
        words.close();
        if (major != MAJOR_VERSION) {
            throw new MalformedMessageException("\"" + name + "\" has version " + major + "." + minor
                    + "; this version of RoboNewbie reads version " + MAJOR_VERSION + ".0");
        }
    }

    private void findThings() throws MalformedMessageException {
        ball = List.of();
        List<Placed> found = new ArrayList<>();
        RsmpNode root = scene.orElseThrow();
        find(root, List.of(root), found);
        Map<PlayerNumber, RsmpFigure> present = new HashMap<>();
        found.forEach(robot -> present.put(robot.player(), robot.figure()));
        figures.clear();
        figures.putAll(present);
        robots = List.copyOf(found);
        current = true;
    }

    private void find(RsmpNode node, List<RsmpNode> path, List<Placed> found) throws MalformedMessageException {
        for (List<String> description : node.descriptions()) {
            List<RsmpNode> bodies = node.transforms();
            if (bodies.size() != 1) {
                throw new MalformedMessageException("\"" + String.join(" ", description) + "\" describes "
                        + bodies.size() + " bodies instead of one");
            }
            if (description.equals(List.of("ball"))) {
                ball = extended(path, bodies.get(0));
            } else if (description.get(0).equals("agent")) {
                found.add(robot(description, path, bodies.get(0)));
            }
        }
        if (found.size() > MAX_ROBOTS) {
            throw new MalformedMessageException("the scene has more than " + MAX_ROBOTS + " robots");
        }
        for (RsmpNode child : node.children()) {
            find(child, extended(path, child), found);
        }
    }

    private static List<RsmpNode> extended(List<RsmpNode> path, RsmpNode child) {
        List<RsmpNode> longer = new ArrayList<>(path);
        longer.add(child);
        return longer;
    }

    private Placed robot(List<String> description, List<RsmpNode> path, RsmpNode torso)
            throws MalformedMessageException {
        if (description.size() != 3) {
            throw new MalformedMessageException(
                    "expected \"agent TEAM NUMBER\", found \"" + String.join(" ", description) + "\"");
        }
        PlayerNumber player = new PlayerNumber(side(description.get(1)), number(description.get(2)));
        RsmpFigure figure = RsmpFigure.of(torso, Optional.ofNullable(figures.get(player)));
        return new Placed(player, path, figure);
    }

    private TeamSide side(String team) throws MalformedMessageException {
        MonitoredGame game = gameReader.gameState();
        if (game.teamLeft().equals(Optional.of(team))) {
            return TeamSide.LEFT;
        }
        if (game.teamRight().equals(Optional.of(team))) {
            return TeamSide.RIGHT;
        }
        throw new MalformedMessageException("the agent's team \"" + team + "\" plays on neither side");
    }

    private static int number(String text) throws MalformedMessageException {
        boolean isNumber = !text.isEmpty() && text.length() <= 4 && text.chars().allMatch(c -> c >= '0' && c <= '9');
        int number = isNumber ? Integer.parseInt(text) : 0;
        if (number < 1 || number > MAX_PLAYER_NUMBER) {
            throw new MalformedMessageException("expected the number of an agent, found \"" + text + "\"");
        }
        return number;
    }
}
