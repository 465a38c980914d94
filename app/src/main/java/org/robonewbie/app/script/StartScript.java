package org.robonewbie.app.script;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.Console;

/**
 * What a start script of rcssserver3d sets: soccer parameters, as {@code addSoccerVar('RuleHalfTime', 5.0 * 60)} or {@code
 * RuleHalfTime = 60}, and the variables {@code $agentPort}, {@code $serverPort}, {@code $agentSyncMode} and {@code
 * $enableRealTimeMode}; also in scripts that it runs. A line that looks like a setting and is none here is named with its reason;
 * everything else in the script is Ruby for the original and stays without effect.
 *
 * <p>Source: the scripts {@code rcssserver3d.rb} and {@code naosoccersim.rb} of rcssserver3d 0.7.3.
 */
public final class StartScript {

    /** A script that sets nothing. */
    public static final StartScript EMPTY = new StartScript(Map.of());

    static final String AGENT_PORT = "$agentPort";
    static final String MONITOR_PORT = "$serverPort";
    static final String SYNCHRONOUS = "$agentSyncMode";
    static final String REAL_TIME = "$enableRealTimeMode";

    private final Map<String, Object> values;

    StartScript(Map<String, Object> values) {
        this.values = values;
    }

    /**
     * Reads a script.
     *
     * @param file the script
     * @param console reports what is left out, with its line
     * @return what it sets
     * @throws CalledWronglyException if it cannot be read or sets something to an impossible value; the message says what to do
     */
    public static StartScript read(Path file, Console console) {
        ScriptReader reader = new ScriptReader(console);
        reader.read(file);
        return new StartScript(reader.values());
    }

    /** {@return the soccer parameters as {@code NAME=VALUE}, in the order of the script} */
    public List<String> parameters() {
        return values.entrySet().stream()
                .filter(entry -> !entry.getKey().startsWith("$"))
                .map(entry -> entry.getKey() + "=" + entry.getValue())
                .toList();
    }

    /** {@return the port for agents; empty if the script does not set it} */
    public Optional<Integer> agentPort() {
        return port(AGENT_PORT);
    }

    /** {@return the port for monitors; empty if the script does not set it} */
    public Optional<Integer> monitorPort() {
        return port(MONITOR_PORT);
    }

    /** {@return whether the world waits for all agents} */
    public boolean isSynchronous() {
        return Boolean.TRUE.equals(values.get(SYNCHRONOUS));
    }

    /** {@return whether the script switches off the waiting for the clock} */
    public boolean isFast() {
        return Boolean.FALSE.equals(values.get(REAL_TIME));
    }

    private Optional<Integer> port(String variable) {
        return Optional.ofNullable(values.get(variable)).map(number -> ((Number) number).intValue());
    }
}
