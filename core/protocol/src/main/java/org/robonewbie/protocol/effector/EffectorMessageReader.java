package org.robonewbie.protocol.effector;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;
import org.robonewbie.protocol.effector.EffectorCommand.RequestPass;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorCommand.Synchronise;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/**
 * Parses the messages that an agent sends to the simulator, following the rules of rcssserver3d: numbers are parsed
 * like C's {@code atof}, incomplete commands are dropped, and no input causes an exception. Invalid commands are
 * reported and skipped. Not thread-safe.
 */
public final class EffectorMessageReader {

    private static final int MAX_PROBLEMS = 10;
    private static final int MAX_WORD = 60;
    private static final Synchronise SYNCHRONISE = new Synchronise();
    private static final RequestPass REQUEST_PASS = new RequestPass();
    private static final String[] HINGES = Stream.concat(
                    Arrays.stream(Joint.values()).map(Joint::effectorName), Stream.of("lle7", "rle7"))
            .toArray(String[]::new);

    private final SexpReader reader = SexpReader.withQuotes();
    private final double[] numbers = new double[3];
    private final SetHingeSpeed[] lastSpeeds =
            Arrays.stream(HINGES).map(name -> new SetHingeSpeed(name, 0)).toArray(SetHingeSpeed[]::new);
    private int expectedHinge;
    private int problemCount;
    private Consumer<? super EffectorCommand> commands = command -> {};
    private Consumer<? super String> problems = problem -> {};

    /** Creates a reader. */
    public EffectorMessageReader() {}

    /**
     * Parses a message.
     *
     * @param message the message as received from the agent
     * @param commandListener receives the commands in order
     * @param problemListener receives one sentence per skipped command, at most ten per message; a final sentence
     *     states how many more were skipped
     */
    public void read(
            MessageBuffer message,
            Consumer<? super EffectorCommand> commandListener,
            Consumer<? super String> problemListener) {
        commands = commandListener;
        problems = problemListener;
        problemCount = 0;
        reader.start(message);
        while (reader.nextList(0)) {
            readCommand();
        }
        if (problemCount > MAX_PROBLEMS) {
            problems.accept((problemCount - MAX_PROBLEMS) + " more commands of this message were ignored");
        }
    }

    private void readCommand() {
        String hinge = findHinge();
        if (!hinge.isEmpty()) {
            readHingeSpeed(hinge);
        } else if (reader.atomIs("syn")) {
            finish(SYNCHRONISE);
        } else if (reader.atomIs("beam")) {
            readBeam();
        } else if (reader.atomIs("say")) {
            readSay();
        } else if (reader.atomIs("pass")) {
            finish(REQUEST_PASS);
        } else if (reader.atomIs("init")) {
            readJoinTeam();
        } else if (reader.atomIs("scene")) {
            readCreateRobot();
        } else {
            ignore("Unknown effector \"" + shownAtom() + "\" was ignored");
        }
    }

    private void readHingeSpeed(String name) {
        if (readNumbers(1)) {
            finish(speedOf(name));
        } else {
            ignore("Joint command \"" + name + "\" was ignored: it needs one number, the speed in radians per second");
        }
    }

    /**
     * Returns the previous command object of the hinge if the speed is unchanged, which avoids allocations for joints at rest.
     */
    private SetHingeSpeed speedOf(String name) {
        int hinge = expectedHinge - 1;
        SetHingeSpeed last = lastSpeeds[hinge];
        if (Double.doubleToLongBits(last.radiansPerSecond()) != Double.doubleToLongBits(numbers[0])) {
            lastSpeeds[hinge] = new SetHingeSpeed(name, numbers[0]);
        }
        return lastSpeeds[hinge];
    }

    private void readBeam() {
        if (readNumbers(3)) {
            finish(new Beam(new Pose2d(numbers[0], numbers[1], numbers[2])));
        } else {
            ignore("\"beam\" was ignored: it needs three numbers, x and y in metres and the heading in degrees");
        }
    }

    /** Reads the text, which is the first word of the list, and skips the rest, as rcssserver3d does. */
    private void readSay() {
        if (reader.next() != Token.ATOM) {
            ignore("\"say\" was ignored: it needs a text of 1 to 20 characters without spaces or parentheses");
            return;
        }
        try {
            finish(new Say(reader.text()));
        } catch (IllegalArgumentException refused) {
            ignore("\"say\" was ignored. " + refused.getMessage());
        }
    }

    private void readJoinTeam() {
        int number = 0;
        String team = "";
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("unum")) {
                number = reader.next() == Token.ATOM ? reader.integer() : 0;
            } else if (reader.atomIs("teamname")) {
                team = reader.next() == Token.ATOM ? reader.text() : "";
            }
        }
        finish(new JoinTeam(number, team));
    }

    private void readCreateRobot() {
        if (reader.next() != Token.ATOM) {
            ignore("\"scene\" was ignored: it needs a file name such as " + CreateRobot.SCENE);
            return;
        }
        String path = reader.text();
        List<String> parameters = new ArrayList<>();
        while (reader.next() == Token.ATOM) {
            parameters.add(reader.text());
        }
        finish(new CreateRobot(path, parameters));
    }

    private boolean readNumbers(int count) {
        for (int i = 0; i < count; i++) {
            if (reader.next() != Token.ATOM) {
                return false;
            }
            numbers[i] = reader.number();
        }
        return true;
    }

    /** Passes on a command if its closing parenthesis has been read. */
    private void finish(EffectorCommand command) {
        reader.skipTo(0);
        if (reader.token() == Token.CLOSE) {
            commands.accept(command);
        }
    }

    private void ignore(String problem) {
        problemCount++;
        if (problemCount <= MAX_PROBLEMS) {
            problems.accept(problem);
        }
    }

    private String shownAtom() {
        String word = reader.text();
        String start = word.length() <= MAX_WORD ? word : word.substring(0, MAX_WORD) + "…";
        return start.chars().allMatch(character -> character > ' ') ? start : "(unprintable)";
    }

    /**
     * Finds the hinge named by the current atom. Starts after the previous hinge, because agents send hinges in a fixed
     * order.
     */
    private String findHinge() {
        for (int i = 0; i < HINGES.length; i++) {
            int candidate = (expectedHinge + i) % HINGES.length;
            if (reader.atomIs(HINGES[candidate])) {
                expectedHinge = candidate + 1;
                return HINGES[candidate];
            }
        }
        return "";
    }
}
