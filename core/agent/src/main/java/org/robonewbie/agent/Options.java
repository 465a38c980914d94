package org.robonewbie.agent;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.robonewbie.agent.running.Surroundings;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.robot.BoosterK1;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotModel;

/**
 * The options that every agent accepts: simulator, team, number, starting pose and others. The sources, in descending
 * order of precedence, are the command line, the file {@code robonewbie.properties} in the working directory, and
 * environment variables such as {@code ROBONEWBIE_HOST}.
 *
 * <pre>{@code
 * Options options = Options.of(args);                     // --host 192.168.0.7 --number 4
 * Options keeper = Options.none().withTeam("Blue").withNumber(1);
 * }</pre>
 */
public final class Options {

    /** Default starting poses of players 1 to 11. All of them fit on the small pitch; player 1 is the goalkeeper. */
    private static final List<Pose2d> LINE_UP = List.of(
            new Pose2d(-5, 0, 0),
            new Pose2d(-0.6, 0, 0),
            new Pose2d(-1, 2, 0),
            new Pose2d(-1, -2, 0),
            new Pose2d(-3, 0, 0),
            new Pose2d(-3, -1.5, 0),
            new Pose2d(-3, 1.5, 0),
            new Pose2d(-4, -2, 0),
            new Pose2d(-4, 0, 0),
            new Pose2d(-4, 2, 0),
            new Pose2d(-2, 0, 0));

    private static final String DEFAULT_TEAM = "RoboNewbie";
    private static final int MAX_X = 28;
    private static final int MAX_Y = 19;

    private final Map<Option, OptionSource.Value> values;
    private final List<String> arguments;
    private final boolean takesWords;

    Options(Map<Option, OptionSource.Value> values, List<String> arguments, boolean takesWords) {
        this.values = values;
        this.arguments = List.copyOf(arguments);
        this.takesWords = takesWords;
        SimulatorChoice.check(this);
    }

    /** {@return options with no values set} */
    public static Options none() {
        return new Options(new EnumMap<>(Option.class), List.of(), false);
    }

    /**
     * Reads the options of this program from all sources.
     *
     * @param args the arguments of {@code main}
     * @return the options
     * @throws StartUpException if an option is unknown or has an invalid value
     */
    public static Options of(String... args) {
        return none().overriddenBy(args);
    }

    /**
     * Reads the options of this program; options that the user does not set keep their current values.
     *
     * @param args the arguments of {@code main}
     * @return the options
     * @throws StartUpException if an option is unknown or has an invalid value
     */
    public Options overriddenBy(String... args) {
        return overriddenBy(Arrays.asList(args), "robonewbie.properties", Surroundings.environment());
    }

    Options overriddenBy(List<String> args, String file, Map<String, String> environment) {
        Map<Option, OptionSource.Value> merged = new EnumMap<>(Option.class);
        merged.putAll(values);
        List<String> others = new ArrayList<>(arguments);
        merged.putAll(OptionSource.ofEnvironment(environment));
        try {
            merged.putAll(OptionSource.ofProperties(Surroundings.properties(file)));
        } catch (IOException unreadable) {
            throw new StartUpException(String.valueOf(unreadable.getMessage()));
        }
        merged.putAll(OptionSource.ofArguments(args, others));
        Options result = new Options(merged, others, takesWords);
        if (isPoseOfAnotherNumber(result)) {
            merged.remove(Option.POSE);
            return new Options(merged, others, takesWords);
        }
        return result;
    }

    /**
     * Returns whether the program's default pose is meant for another player number. Such a pose must not be used,
     * because all players of a team would start in it.
     */
    private boolean isPoseOfAnotherNumber(Options overriding) {
        int defaultNumber = Math.max(1, number());
        boolean samePose =
                pose().equals(overriding.pose()) && overriding.strength(Option.POSE) == strength(Option.POSE);
        return samePose && overriding.number() > 0 && overriding.number() != defaultNumber;
    }

    /** {@return the help text, one line for each option} */
    public static String help() {
        return Arrays.stream(Option.values()).map(Option::helpLine).collect(Collectors.joining("\n"))
                + "\nEach option can also be set in robonewbie.properties (such as host=192.168.0.7) or in the environment"
                + " (such as ROBONEWBIE_HOST).";
    }

    /**
     * Accepts arguments that are not options, such as a file name. Without this call, they are rejected.
     *
     * @return these options, accepting other arguments
     */
    public Options withWords() {
        return new Options(values, arguments, true);
    }

    void checkWords() {
        if (!takesWords && !arguments.isEmpty()) {
            throw new StartUpException("\"" + arguments.get(0)
                    + "\" is not an option. Options begin with --, such as --seconds 5; --help lists them. A program"
                    + " that takes other arguments declares this in defaults(): Options.none().withWords().");
        }
    }

    /**
     * Sets the team name.
     *
     * @param team name of the team
     * @return options with that team
     */
    public Options withTeam(String team) {
        return with(Option.TEAM, team);
    }

    /**
     * Sets the player number.
     *
     * @param number 1 to 11, or 0 for any free number
     * @return options with that number
     */
    public Options withNumber(int number) {
        return with(Option.NUMBER, Integer.toString(number));
    }

    /**
     * Sets the starting pose.
     *
     * @param x metres from the centre; the team's own half has x ≤ 0
     * @param y metres to the left of the centre
     * @param degrees heading; 0 is towards the opponents' goal, positive is left
     * @return options with that pose
     */
    public Options withPose(double x, double y, double degrees) {
        return with(Option.POSE, x + "," + y + "," + degrees);
    }

    /**
     * Sets the duration of the run.
     *
     * @param seconds simulated seconds, above 0
     * @return options with that duration
     */
    public Options withSeconds(double seconds) {
        return with(Option.SECONDS, Double.toString(seconds));
    }

    /**
     * Sets an option by its name on the command line.
     *
     * @param name name of the option, such as {@code seed}
     * @param value value of the option, such as {@code 1}; {@code true} for a flag
     * @return options with that value
     * @throws StartUpException if there is no such option or the value is invalid
     */
    public Options with(String name, String value) {
        return with(OptionSource.find(name, "program"), value);
    }

    private Options with(Option option, String value) {
        Map<Option, OptionSource.Value> changed = new EnumMap<>(Option.class);
        changed.putAll(values);
        changed.put(option, OptionSource.PROGRAM.value(option, value));
        return new Options(changed, arguments, takesWords);
    }

    /** {@return the server's host name or address, if set} */
    public Optional<String> host() {
        return text(Option.HOST);
    }

    /** {@return the server's TCP port, if set} */
    public OptionalInt port() {
        Optional<String> port = text(Option.PORT);
        return port.isPresent() ? OptionalInt.of(Integer.parseInt(port.get())) : OptionalInt.empty();
    }

    /** {@return the team name; {@code RoboNewbie} if not set} */
    public String team() {
        return text(Option.TEAM).orElse(DEFAULT_TEAM);
    }

    /** {@return the player number, 1 to 11; 0 for any free number} */
    public int number() {
        return text(Option.NUMBER).map(Integer::valueOf).orElse(0);
    }

    /** {@return the starting pose, if set} */
    public Optional<Pose2d> pose() {
        return text(Option.POSE).map(Options::parsePose);
    }

    /**
     * Returns the starting pose in the coordinates of the robot's team.
     *
     * @param number the player number, 1 to 11
     * @return the pose that was set, otherwise the default pose for this number in the team's own half
     * @throws IllegalArgumentException if the number is outside that range
     */
    public Pose2d pose(int number) {
        if (number < 1 || number > LINE_UP.size()) {
            throw new IllegalArgumentException("Players have numbers 1 to 11, not " + number);
        }
        return pose().orElse(LINE_UP.get(number - 1));
    }

    /** {@return the robot type, 0 to 4, see {@code org.robonewbie.nao.model.RobotType}} */
    public int type() {
        return text(Option.TYPE).map(Integer::valueOf).orElse(0);
    }

    /** {@return the robot to play with: {@code NAO}, or {@code T1} or {@code K1}, which play on RCSSServerMJ} */
    public String robot() {
        return text(Option.ROBOT).orElse("NAO");
    }

    /** Returns the model of the robot if it plays on RCSSServerMJ; empty for a NAO. */
    Optional<RobotModel> leagueRobot() {
        return switch (robot()) {
            case "T1" -> Optional.of(BoosterT1.MODEL);
            case "K1" -> Optional.of(BoosterK1.MODEL);
            default -> Optional.empty();
        };
    }

    RobotType robotType() {
        return RobotType.values()[type()];
    }

    /** {@return the random seed; empty if the run need not be repeatable} */
    public OptionalLong seed() {
        Optional<String> seed = text(Option.SEED);
        return seed.isPresent() ? OptionalLong.of(Long.parseLong(seed.get())) : OptionalLong.empty();
    }

    /** {@return whether the embedded simulator runs as fast as it can instead of in real time} */
    public boolean isFast() {
        return isSet(Option.FAST);
    }

    /** {@return simulated seconds until the run ends; empty for no limit} */
    public OptionalDouble seconds() {
        Optional<String> seconds = text(Option.SECONDS);
        return seconds.isPresent() ? OptionalDouble.of(Double.parseDouble(seconds.get())) : OptionalDouble.empty();
    }

    /** {@return whether to run without the studio} */
    public boolean isHeadless() {
        return isSet(Option.HEADLESS);
    }

    /** {@return whether the studio starts without opening a browser} */
    public boolean isNoBrowser() {
        return isSet(Option.NO_BROWSER);
    }

    /** {@return whether camera pictures include the true positions of the robot and the ball, for experiments} */
    public boolean isTruth() {
        return isSet(Option.TRUTH);
    }

    /** {@return the policy file for the walk of a robot of today's league; empty for the shipped one} */
    public Optional<String> walk() {
        return text(Option.WALK);
    }

    /** {@return the JSON file for the report, if any} */
    public Optional<String> report() {
        return text(Option.REPORT);
    }

    /** {@return the file for the recording, if any} */
    public Optional<String> record() {
        return text(Option.RECORD);
    }

    /** {@return the name of the scene; empty for the bare pitch} */
    public Optional<String> scene() {
        return text(Option.SCENE);
    }

    /** {@return the number of robots that must have joined before the simulator starts its clock, at least 1} */
    public int waitFor() {
        return text(Option.WAIT_FOR).map(Integer::valueOf).orElse(1);
    }

    /** {@return the arguments that are not options, in the order of the command line} */
    public List<String> arguments() {
        return arguments;
    }

    boolean isHelp() {
        return isSet(Option.HELP);
    }

    /** Returns the precedence of an option's source; -1 if the option is not set. */
    int strength(Option option) {
        OptionSource.Value value = values.get(option);
        return value == null || value.text().equals("false") ? -1 : value.strength();
    }

    private boolean isSet(Option option) {
        return text(option).filter("true"::equals).isPresent();
    }

    private Optional<String> text(Option option) {
        return Optional.ofNullable(values.get(option)).map(OptionSource.Value::text);
    }

    private static Pose2d parsePose(String text) {
        double[] numbers =
                Arrays.stream(text.split(",")).mapToDouble(Double::parseDouble).toArray();
        if (Math.abs(numbers[0]) > MAX_X || Math.abs(numbers[1]) > MAX_Y) {
            throw new StartUpException("--pose " + text + " is outside every pitch: x is at most " + MAX_X
                    + " m from the centre, y " + MAX_Y + " m; your own half has negative x, such as --pose -2,1,90.");
        }
        return new Pose2d(numbers[0], numbers[1], numbers[2]);
    }
}
