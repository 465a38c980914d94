package org.robonewbie.agent;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.text.Spelling;

/** One option of an agent: its name, what it takes and what the help says about it. */
enum Option {
    HOST("HOST", "join the server on this computer", Values::text),
    PORT("N", "its port, 3100 if left out", Values.wholeNumber(1, 65535)),
    TEAM("NAME", "name of the team, without blanks or brackets", Values::name),
    NUMBER(
            "N",
            "number on the shirt, 1 to 11, each with a place of its own; 0 takes a free one",
            Values.wholeNumber(0, 11)),
    POSE(
            "X,Y,DEGREES",
            "where to start: metres, own half has x <= 0; 0 degrees looks at the opponents' goal",
            Values::pose),
    TYPE("N", "build of the robot, 0 to 4", Values.wholeNumber(0, 4)),
    SEED("N", "start a simulator of its own whose run can be repeated exactly", Values::longNumber),
    FAST("", "start a simulator of its own that runs as fast as it can", Values::flag),
    SECONDS("T", "end after so many simulated seconds", Values::positive),
    HEADLESS("", "no studio", Values::flag),
    NO_BROWSER("", "studio, but do not open a browser", Values::flag),
    TRUTH("", "let the camera also report the true places of robot and ball (own simulator)", Values::flag),
    REPORT("FILE", "write the true results as JSON (own simulator)", Values::text),
    RECORD("FILE", "record the run (own simulator)", Values::text),
    WAIT_FOR("N", "hold the first cycle until N robots are in (own simulator)", Values.wholeNumber(1, 22)),
    SCENE("NAME", "what stands on the pitch: soccer, obstacles, slope or box (own simulator)", Values::text),
    HELP("", "show this help", Values::flag);

    private final String placeholder;
    private final String description;

    @SuppressWarnings("ImmutableEnumChecker")
    private final Values.Check check;

    Option(String placeholder, String description, Values.Check check) {
        this.placeholder = placeholder;
        this.description = description;
        this.check = check;
    }

    /** The name on the command line, such as {@code --no-browser}. */
    String argument() {
        return "--" + key();
    }

    /** The name in a properties file, such as {@code no-browser}. */
    String key() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The name of the environment variable, such as {@code ROBONEWBIE_NO_BROWSER}. */
    String variable() {
        return "ROBONEWBIE_" + name();
    }

    boolean isFlag() {
        return placeholder.isEmpty();
    }

    /** What is wrong with a value; empty if nothing is. */
    Optional<String> complaint(String value) {
        return check.complaint(value);
    }

    String helpLine() {
        return String.format(Locale.ROOT, "  %-22s %s", argument() + " " + placeholder, description);
    }

    static Optional<Option> ofKey(String key) {
        return Arrays.stream(values())
                .filter(option -> option.key().equals(key))
                .findFirst();
    }

    /** Asks for the option whose name is most like a misspelt one. */
    static String question(String key) {
        String question =
                Spelling.question(key, Arrays.stream(values()).map(Option::key).toList(), near -> "--" + near);
        return question.isEmpty() ? " --help lists all options." : question;
    }
}
