package org.robonewbie.simulator.script;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.simulator.script.RubyToken.Kind;
import org.robonewbie.simulator.soccer.SoccerParameter;

/** The settings supported in start scripts, and replacements for the unsupported settings of rcssserver3d. */
final class SettingAdvice {

    private static final Set<String> TAKEN =
            Set.of(StartScript.AGENT_PORT, StartScript.MONITOR_PORT, StartScript.SYNCHRONOUS, StartScript.REAL_TIME);

    private static final String SHORT_CYCLE = "a cycle is always 0.02 s long here.";
    private static final String PHYSICS = "the world's constants are those of the original and cannot be changed.";
    private static final String THREADS = "it has no effect here.";

    /** Replacement for each unsupported variable of {@code spark.rb} and {@code rcssserver3d.rb}. */
    private static final Map<String, String> ORIGINAL = Map.ofEntries(
            Map.entry("$recordLogfile", "use the option --log FILE."),
            Map.entry("$recordLogfileName", "use the option --log FILE."),
            Map.entry("$monitorStep", "use the option --monitor-step T."),
            Map.entry("$monitorLoggerStep", "a log has a line for each message to monitors; use --monitor-step T."),
            Map.entry("$renderStep", "the studio renders at its own rate."),
            Map.entry("$enableInternalMonitor", "use a monitor, or \"robonewbie studio\"."),
            Map.entry("$agentStep", SHORT_CYCLE),
            Map.entry("$serverSimulationStep", SHORT_CYCLE),
            Map.entry("$agentType", "agents always join by TCP here."),
            Map.entry("$serverType", "monitors always join by TCP here."),
            Map.entry("$monitorType", "monitors always join by TCP here."),
            Map.entry("$monitorServer", "it is for rcssmonitor3d."),
            Map.entry("$monitorPort", "it is for rcssmonitor3d; the port of this server is $serverPort."),
            Map.entry("$threadedAgentControl", THREADS),
            Map.entry("$serverMultiThreadedMode", THREADS),
            Map.entry("$monitorMultiThreadedMode", THREADS),
            Map.entry("$defaultTimerSystem", THREADS),
            Map.entry("$defaultPhysicsBundle", PHYSICS),
            Map.entry("$physicsGlobalCFM", PHYSICS),
            Map.entry("$physicsGlobalERP", PHYSICS),
            Map.entry("$physicsGlobalGravity", PHYSICS));

    private static final Set<String> STANDARD_SCRIPTS = Set.of(
            "spark.rb",
            "oxygen.rb",
            "kerosin.rb",
            "zeitgeist.rb",
            "rcssserver3d.rb",
            "rcssserverspl.rb",
            "rcssmonitor3d.rb",
            "naosoccersim.rb",
            "naosoccerspl.rb",
            "naorobottypes.rb",
            "soccersim.rb",
            "simspark.rb",
            "sparkagent.rb");

    private SettingAdvice() {}

    static boolean isTaken(String name) {
        return TAKEN.contains(name) || isParameter(name);
    }

    static boolean isParameter(String name) {
        return SoccerParameter.ofSimSparkName(name).isPresent();
    }

    /** Returns whether a name differs from a parameter's name only in case. */
    static boolean isParameterInOtherLetters(String name) {
        return Arrays.stream(SoccerParameter.values())
                .anyMatch(each -> each.simSparkName().equalsIgnoreCase(name));
    }

    static boolean isStandardScript(String path) {
        return STANDARD_SCRIPTS.contains(path.substring(path.lastIndexOf('/') + 1));
    }

    /** Returns a sentence of advice on an unsupported setting. */
    static String of(String name, Optional<Object> value) {
        String known = ORIGINAL.get(name);
        if (known != null) {
            boolean step = name.equals("$monitorStep") && value.isPresent();
            return step ? known.replace(" T.", " " + value.get() + ".") : known;
        }
        return name.startsWith("$")
                ? "there is no such setting here."
                        + Spelling.question(
                                name,
                                Stream.concat(TAKEN.stream(), ORIGINAL.keySet().stream())
                                        .sorted()
                                        .toList())
                : "there is no parameter " + name + "." + SoccerParameter.question(name);
    }

    /** Returns an example of a supported way to write a setting. */
    static String example(List<RubyToken> tokens) {
        RubyToken first = tokens.get(0);
        if (first.kind() == Kind.GLOBAL) {
            return first.text() + " = VALUE on a separate line";
        }
        if (first.isWord("Soccer") && tokens.size() > 2) {
            return "addSoccerVar('" + tokens.get(2).text() + "', VALUE)";
        }
        return first.isWord("run") ? "run \"FILE\"" : "addSoccerVar('NAME', VALUE) on a separate line";
    }

    /** Returns a token in abbreviated form, for messages. */
    static String quoted(RubyToken token) {
        return token.kind() == Kind.STRING
                ? "'" + token.text() + "'"
                : token.kind() == Kind.OTHER_STRING ? "'…'" : token.text();
    }
}
