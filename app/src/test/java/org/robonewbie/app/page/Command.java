package org.robonewbie.app.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.agent.Options;
import org.robonewbie.app.command.RoboNewbieCommand;
import org.robonewbie.programs.ExampleCatalogue;
import picocli.CommandLine;

/**
 * A command of RoboNewbie, as a page shows it.
 *
 * @param words the command and its arguments
 */
public record Command(List<String> words) {

    private static final Pattern LINE = Pattern.compile("(?:\\./)?robonewbie(?: +([^#\\s].*?))?(?: +#.*)?");
    private static final Pattern WORD = Pattern.compile("\"[^\"]*\"|'[^']*'|\\S+");
    private static final String SHORT_RUN = "--headless --fast --seed 1 --seconds 2";

    /** Options for commands that open a browser, or run until they are stopped. */
    private static final Map<String, String> OPTIONS = Map.of(
            "run", SHORT_RUN,
            "demo", SHORT_RUN,
            "doctor", "--headless",
            "competition", "--headless",
            "optimise", "--headless");

    /** Commands that no option ends. */
    private static final Set<String> ENDLESS = Set.of("studio", "simulator");

    /** Commands that hand options on to an agent. */
    private static final Set<String> OF_AGENTS = Set.of("run", "demo", "record");

    private static final CommandLine ALL = RoboNewbieCommand.commandLine();

    /** Reads a line, with or without a comment; empty if it is not a command of RoboNewbie. */
    public static Optional<Command> of(String line) {
        Matcher matcher = LINE.matcher(line.strip());
        return matcher.matches()
                ? Optional.of(
                        new Command(words(Optional.ofNullable(matcher.group(1)).orElse("demo"))))
                : Optional.empty();
    }

    private static List<String> words(String text) {
        return WORD.matcher(text)
                .results()
                .map(word -> word.group().replaceAll("^([\"'])(.*)\\1$", "$2"))
                .toList();
    }

    /** {@return the first word, such as {@code run}} */
    public String name() {
        return words.get(0);
    }

    /** {@return whether the command can run in a test} */
    public boolean ends() {
        return !ENDLESS.contains(name());
    }

    /** {@return the command without a browser, fast and short, unless it says otherwise} */
    public Command forTest() {
        Command quiet = new Command(
                words.stream().filter(word -> !word.equals("--watch")).toList());
        return each(OPTIONS.getOrDefault(name(), ""))
                .filter(option -> !words.contains(option.get(0)))
                .reduce(quiet, Command::with, (first, second) -> second);
    }

    /** Returns the command with options in the place of those of the same name. */
    public Command with(String options) {
        return each(options).reduce(this, Command::with, (first, second) -> second);
    }

    private Command with(List<String> option) {
        List<String> all = new ArrayList<>(words);
        int place = all.indexOf(option.get(0));
        if (place >= 0) {
            all.subList(place, place + option.size()).clear();
        }
        all.addAll(option);
        return new Command(List.copyOf(all));
    }

    private static Stream<List<String>> each(String options) {
        return Stream.of(options.split(" (?=--)", -1))
                .filter(option -> !option.isEmpty())
                .map(Command::words);
    }

    /** Asserts that the whole command is understood. */
    public void assertValid() {
        assertThatCode(() -> ALL.parseArgs(words.toArray(String[]::new))).doesNotThrowAnyException();
        assertKnown();
        if (name().equals("run") && words.get(1).startsWith("Agent_")) {
            assertThat(ExampleCatalogue.classNames()).containsKey(words.get(1));
        }
    }

    /** Asserts that the command and its options exist. */
    void assertKnown() {
        CommandLine command = ALL.getSubcommands().getOrDefault(name(), ALL);
        String ofAgents = OF_AGENTS.contains(name()) ? Options.help() : "";
        assertThat(words)
                .map(word -> word.replaceFirst("=.*", ""))
                .filteredOn(word -> word.matches("--?[a-zA-Z][-a-zA-Z]*"))
                .allMatch(word ->
                        command.getCommandSpec().optionsMap().containsKey(word) || ofAgents.contains(word + " "));
        assertThat(command != ALL || name().startsWith("-") || name().equals("help"))
                .as(name())
                .isTrue();
    }
}
