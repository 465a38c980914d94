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

/**
 * Where a robot lives and who it is: the same options for every agent. They are taken from the command line, from the file
 * {@code robonewbie.properties} in the working directory and from environment variables such as {@code ROBONEWBIE_HOST}, in
 * this order of precedence.
 *
 * <pre>{@code
 * Options options = Options.of(args);                     // --host 192.168.0.7 --number 4
 * Options keeper = Options.none().withTeam("Blue").withNumber(1);
 * }</pre>
 */
public final class Options {

    /** A line-up for numbers 1 to 11 that fits on the small pitch; number 1 keeps the goal. */
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
    private static final int MAX_X = 20;
    private static final int MAX_Y = 15;

    private final Map<Option, OptionSource.Value> values;
    private final List<String> arguments;
    private final boolean takesWords;

    Options(Map<Option, OptionSource.Value> values, List<String> arguments, boolean takesWords) {
        this.values = values;
        this.arguments = List.copyOf(arguments);
        this.takesWords = takesWords;
        SimulatorChoice.check(this);
    }

    /** {@return options that are all left open} */
    public static Options none() {
        return new Options(new EnumMap<>(Option.class), List.of(), false);
    }

    /**
     * Reads the options of this program.
     *
     * @param args the arguments of {@code main}
     * @return the options
     * @throws StartUpException if an option is unknown or has a wrong value
     */
    public static Options of(String... args) {
        return none().overriddenBy(args);
    }

    /**
     * Reads the options of this program and falls back to these options for what the user leaves open.
     *
     * @param args the arguments of {@code main}
     * @return the options
     * @throws StartUpException if an option is unknown or has a wrong value
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
        return isPlaceOfAnother(result) ? result.withoutPose() : result;
    }

    /** A place that the program names is that of its usual number, else all players of a team would start on one spot. */
    private boolean isPlaceOfAnother(Options overriding) {
        int usualNumber = Math.max(1, number());
        boolean samePlace =
                pose().equals(overriding.pose()) && overriding.strength(Option.POSE) == strength(Option.POSE);
        return samePlace && overriding.number() > 0 && overriding.number() != usualNumber;
    }

    private Options withoutPose() {
        Map<Option, OptionSource.Value> changed = new EnumMap<>(Option.class);
        changed.putAll(values);
        changed.remove(Option.POSE);
        return new Options(changed, arguments, takesWords);
    }

    /** {@return the help: one line for each option} */
    public static String help() {
        return Arrays.stream(Option.values()).map(Option::helpLine).collect(Collectors.joining("\n"))
                + "\nEach option can also stand in robonewbie.properties (such as host=192.168.0.7) or in the environment"
                + " (such as ROBONEWBIE_HOST).";
    }

    /**
     * Lets the program take words that are not options, such as the name of a file. Without this they are refused.
     *
     * @return these options, open for words
     */
    public Options withWords() {
        return new Options(values, arguments, true);
    }

    /** Refuses words that the program does not take. */
    void checkWords() {
        if (!takesWords && !arguments.isEmpty()) {
            throw new StartUpException("\"" + arguments.get(0)
                    + "\" means nothing to this program. Options begin with --, such as --seconds 5; --help lists them. A program"
                    + " that takes words says so in defaults(): Options.none().withWords().");
        }
    }

    /**
     * Sets the team.
     *
     * @param team the team's name
     * @return these options with the other team
     */
    public Options withTeam(String team) {
        return with(Option.TEAM, team);
    }

    /**
     * Sets the number on the shirt.
     *
     * @param number 1 to 11, or 0 for any free number
     * @return these options with the other number
     */
    public Options withNumber(int number) {
        return with(Option.NUMBER, Integer.toString(number));
    }

    /**
     * Sets the start.
     *
     * @param x metres from the centre, your half has x ≤ 0
     * @param y metres to the left of the centre
     * @param degrees direction to look to; 0 is towards the opponents' goal, positive is left
     * @return these options with the other start
     */
    public Options withPose(double x, double y, double degrees) {
        return with(Option.POSE, x + "," + y + "," + degrees);
    }

    /**
     * Sets the end of the run.
     *
     * @param seconds simulated seconds, above 0
     * @return these options with the other end
     */
    public Options withSeconds(double seconds) {
        return with(Option.SECONDS, Double.toString(seconds));
    }

    /**
     * Sets one option by its name on the command line.
     *
     * @param name such as {@code seed}
     * @param value such as {@code 1}; {@code true} switches a flag on
     * @return these options with the other value
     * @throws StartUpException if there is no such option or it cannot have this value
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

    /** {@return the name of the server's computer; empty if the user leaves it open} */
    public Optional<String> host() {
        return text(Option.HOST);
    }

    /** {@return the server's TCP port; empty if the user leaves it open} */
    public OptionalInt port() {
        Optional<String> port = text(Option.PORT);
        return port.isPresent() ? OptionalInt.of(Integer.parseInt(port.get())) : OptionalInt.empty();
    }

    /** {@return the team's name, {@code RoboNewbie} if the user leaves it open} */
    public String team() {
        return text(Option.TEAM).orElse(DEFAULT_TEAM);
    }

    /** {@return the number on the shirt, 1 to 11; 0 for any free number} */
    public int number() {
        return text(Option.NUMBER).map(Integer::valueOf).orElse(0);
    }

    /** {@return where the robot starts; empty if the user leaves it open} */
    public Optional<Pose2d> pose() {
        return text(Option.POSE).map(Options::parsePose);
    }

    /**
     * Returns where the robot starts, in the coordinates of its team.
     *
     * @param number the robot's number, 1 to 11
     * @return the pose that the user wants, else the usual place of this number in the own half
     * @throws IllegalArgumentException if there is no such number
     */
    public Pose2d pose(int number) {
        if (number < 1 || number > LINE_UP.size()) {
            throw new IllegalArgumentException("Robots have the numbers 1 to 11, not " + number);
        }
        return pose().orElse(LINE_UP.get(number - 1));
    }

    /** {@return the build of the robot, 0 to 4, see {@code org.robonewbie.nao.model.RobotType}} */
    public int type() {
        return text(Option.TYPE).map(Integer::valueOf).orElse(0);
    }

    RobotType robotType() {
        return RobotType.values()[type()];
    }

    /** {@return the start of all random numbers; empty if the run need not be repeatable} */
    public OptionalLong seed() {
        Optional<String> seed = text(Option.SEED);
        return seed.isPresent() ? OptionalLong.of(Long.parseLong(seed.get())) : OptionalLong.empty();
    }

    /** {@return whether the program's own simulator runs as fast as it can instead of in real time} */
    public boolean isFast() {
        return isSet(Option.FAST);
    }

    /** {@return simulated seconds until the run ends; empty if it has no end of its own} */
    public OptionalDouble seconds() {
        Optional<String> seconds = text(Option.SECONDS);
        return seconds.isPresent() ? OptionalDouble.of(Double.parseDouble(seconds.get())) : OptionalDouble.empty();
    }

    /** {@return whether there is no studio} */
    public boolean isHeadless() {
        return isSet(Option.HEADLESS);
    }

    /** {@return whether the studio is not opened in the browser} */
    public boolean isNoBrowser() {
        return isSet(Option.NO_BROWSER);
    }

    /** {@return whether pictures of the camera tell the true places of robot and ball, for experiments} */
    public boolean isTruth() {
        return isSet(Option.TRUTH);
    }

    /** {@return the JSON file for the true results; empty for none} */
    public Optional<String> report() {
        return text(Option.REPORT);
    }

    /** {@return the file for the recording; empty for none} */
    public Optional<String> record() {
        return text(Option.RECORD);
    }

    /** {@return the name of what stands on the pitch; empty for the bare pitch} */
    public Optional<String> scene() {
        return text(Option.SCENE);
    }

    /** {@return how many robots must be in before the simulator starts its clock, at least 1} */
    public int waitFor() {
        return text(Option.WAIT_FOR).map(Integer::valueOf).orElse(1);
    }

    /** {@return the arguments that are not options, in their order} */
    public List<String> arguments() {
        return arguments;
    }

    boolean isHelp() {
        return isSet(Option.HELP);
    }

    /** Returns how much weight an option has: the more, the nearer to the command line it was set; -1 if it is not set at all. */
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
            throw new StartUpException("--pose " + text + " is far outside of every pitch: x is at most " + MAX_X
                    + " m from the centre, y " + MAX_Y + " m; your own half has negative x, such as --pose -2,1,90.");
        }
        return new Pose2d(numbers[0], numbers[1], numbers[2]);
    }
}
