package org.robonewbie.simulator.script;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.simulator.Console;

/**
 * Settings in a start script of rcssserver3d: soccer parameters, as {@code addSoccerVar('RuleHalfTime', 5.0 * 60)} or
 * {@code RuleHalfTime = 60}, and the variables {@code $agentPort}, {@code $serverPort}, {@code $agentSyncMode} and
 * {@code $enableRealTimeMode}, including settings in the scripts that it runs. Lines that look like settings but are
 * not supported are reported with a reason; all other Ruby code is ignored.
 *
 * <p>Source: the scripts {@code rcssserver3d.rb} and {@code naosoccersim.rb} of rcssserver3d 0.7.3.
 */
public final class StartScript {

    /** An empty script. */
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
     * @param console receives a message for each ignored setting, with its line
     * @return its settings
     * @throws UnreadableFileException if it cannot be read or sets an invalid value; the message says what to do
     */
    public static StartScript read(Path file, Console console) throws UnreadableFileException {
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

    /** {@return the agent port; empty if not set by the script} */
    public Optional<Integer> agentPort() {
        return port(AGENT_PORT);
    }

    /** {@return the monitor port; empty if not set by the script} */
    public Optional<Integer> monitorPort() {
        return port(MONITOR_PORT);
    }

    /** {@return whether the simulation waits for all agents in each cycle} */
    public boolean isSynchronous() {
        return Boolean.TRUE.equals(values.get(SYNCHRONOUS));
    }

    /** {@return whether the script turns off real-time mode} */
    public boolean isFast() {
        return Boolean.FALSE.equals(values.get(REAL_TIME));
    }

    private Optional<Integer> port(String variable) {
        return Optional.ofNullable(values.get(variable)).map(number -> ((Number) number).intValue());
    }
}
