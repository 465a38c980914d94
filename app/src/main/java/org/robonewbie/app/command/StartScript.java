package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.soccer.SoccerParameter;

/**
 * What a start script of rcssserver3d sets by plain assignments: soccer parameters, as {@code addSoccerVar('RuleHalfTime',
 * 60)} or {@code RuleHalfTime = 60}, and the variables {@code $agentPort}, {@code $serverPort}, {@code $agentSyncMode} and
 * {@code $enableRealTimeMode}. Everything else in it is Ruby and is left out.
 *
 * <p>Source: the scripts {@code rcssserver3d.rb} and {@code naosoccersim.rb} of rcssserver3d 0.7.3.
 */
final class StartScript {

    static final StartScript EMPTY = new StartScript(Map.of());

    private static final String VALUE = "['\"]?([-+.\\w]+)['\"]?";
    private static final Pattern CALL =
            Pattern.compile("addSoccerVar\\s*\\(?\\s*['\"](\\w+)['\"]\\s*,\\s*" + VALUE + "\\s*\\)?");
    private static final Pattern ASSIGNMENT = Pattern.compile("(\\$?\\w+)\\s*=\\s*" + VALUE);
    private static final Pattern COMMENT = Pattern.compile("#.*");

    private final Map<String, String> values;

    private StartScript(Map<String, String> values) {
        this.values = values;
    }

    /**
     * Reads a script.
     *
     * @param file the script
     * @param console reports what is left out
     * @throws CalledWronglyException if it cannot be read
     */
    static StartScript read(Path file, Console console) {
        List<String> lines;
        try {
            lines = Files.readAllLines(file);
        } catch (IOException unreadable) {
            throw new CalledWronglyException("The script " + file + " cannot be read. Is its name and folder right?");
        }
        Map<String, String> values = new LinkedHashMap<>();
        int leftOut = 0;
        for (String line : lines) {
            String statement = COMMENT.matcher(line).replaceFirst("").trim();
            if (!statement.isEmpty() && !take(statement, values)) {
                leftOut++;
            }
        }
        if (leftOut > 0) {
            console.say(
                    "Of the script " + file + " " + leftOut + " lines were left out, since they are more than a plain"
                            + " assignment of something known here.");
        }
        return new StartScript(values);
    }

    private static boolean take(String statement, Map<String, String> values) {
        for (Pattern pattern : List.of(CALL, ASSIGNMENT)) {
            Matcher matcher = pattern.matcher(statement);
            if (matcher.matches() && isKnown(matcher.group(1))) {
                values.put(matcher.group(1), matcher.group(2));
                return true;
            }
        }
        return false;
    }

    private static boolean isKnown(String name) {
        return switch (name) {
            case "$agentPort", "$serverPort", "$agentSyncMode", "$enableRealTimeMode" -> true;
            default -> SoccerParameter.ofSimSparkName(name).isPresent();
        };
    }

    /** The soccer parameters as {@code NAME=VALUE}, in the order of the script. */
    List<String> parameters() {
        return values.entrySet().stream()
                .filter(entry -> !entry.getKey().startsWith("$"))
                .map(entry -> entry.getKey() + "=" + entry.getValue())
                .toList();
    }

    Optional<Integer> agentPort() {
        return port("$agentPort");
    }

    Optional<Integer> monitorPort() {
        return port("$serverPort");
    }

    boolean isSynchronous() {
        return "true".equals(values.get("$agentSyncMode"));
    }

    /** Whether the script switches off the waiting for the clock. */
    boolean isFast() {
        return "false".equals(values.get("$enableRealTimeMode"));
    }

    private Optional<Integer> port(String variable) {
        try {
            return Optional.ofNullable(values.get(variable)).map(Integer::valueOf);
        } catch (NumberFormatException wrong) {
            throw new CalledWronglyException(
                    "The script sets " + variable + " to " + values.get(variable) + ", which is not a port number.");
        }
    }
}
