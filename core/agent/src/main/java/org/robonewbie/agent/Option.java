package org.robonewbie.agent;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.text.Spelling;

/** Command-line option of an agent: name, value and help text. */
enum Option {
    HOST("HOST", "join the server on the computer HOST", Values.TEXT),
    PORT("N", "port of that server (default: 3100)", Values.wholeNumber(1, 65535)),
    TEAM("NAME", "team name, without spaces or brackets", Values.NAME),
    NUMBER(
            "N",
            "player number, 1 to 11, each with its own starting pose; 0 takes any free number",
            Values.wholeNumber(0, 11)),
    POSE("X,Y,DEGREES", "starting pose: metres, own half has x <= 0; 0 degrees faces the opponents' goal", Values.POSE),
    TYPE("N", "robot type, 0 to 4", Values.wholeNumber(0, 4)),
    ROBOT(
            "NAME",
            "NAO, or T1 or K1 to play on RCSSServerMJ, the server of today's league (port 60000)",
            Values.oneOf("NAO", "T1", "K1")),
    WALK("FILE", "policy for the walk of a T1 or K1, instead of the one shipped for the T1", Values.TEXT),
    SEED("N", "start an embedded simulator with this random seed", Values.LONG),
    FAST("", "start an embedded simulator that runs as fast as possible", Values.FLAG),
    SECONDS("T", "end the run after T simulated seconds", Values.POSITIVE),
    HEADLESS("", "do not start the studio", Values.FLAG),
    NO_BROWSER("", "start the studio without opening a browser", Values.FLAG),
    TRUTH("", "add the true positions of robot and ball to camera pictures (embedded simulator, T1, K1)", Values.FLAG),
    REPORT("FILE", "write a report as JSON (embedded simulator)", Values.TEXT),
    RECORD("FILE", "record the run (embedded simulator)", Values.TEXT),
    WAIT_FOR("N", "hold the first cycle until N robots have joined (embedded simulator)", Values.wholeNumber(1, 22)),
    SCENE("NAME", "scene on the pitch: soccer, obstacles, slope or box (embedded simulator)", Values.TEXT),
    HELP("", "show this help", Values.FLAG);

    private final String placeholder;
    private final String description;

    @SuppressWarnings("ImmutableEnumChecker")
    private final Values valid;

    Option(String placeholder, String description, Values valid) {
        this.placeholder = placeholder;
        this.description = description;
        this.valid = valid;
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

    Values valid() {
        return valid;
    }

    String helpLine() {
        return String.format(Locale.ROOT, "  %-22s %s", argument() + " " + placeholder, description);
    }

    static Optional<Option> ofKey(String key) {
        return Arrays.stream(values())
                .filter(option -> option.key().equals(key))
                .findFirst();
    }

    /** Returns a question that suggests the option with the name most similar to a misspelt one. */
    static String question(String key) {
        String question =
                Spelling.question(key, Arrays.stream(values()).map(Option::key).toList(), near -> "--" + near);
        return question.isEmpty() ? " --help lists all options." : question;
    }
}
