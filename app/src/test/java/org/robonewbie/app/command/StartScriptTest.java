package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.program.CalledWronglyException;

class StartScriptTest {

    @TempDir
    Path folder = Path.of("");

    private final List<String> told = new ArrayList<>();

    @Test
    void readsSoccerVariables() throws IOException {
        StartScript script = read("addSoccerVar('RuleHalfTime', 60)\n addSoccerVar 'UseCharging', false # no fouls\n");

        assertThat(script.parameters()).containsExactly("RuleHalfTime=60", "UseCharging=false");
    }

    @Test
    void readsAssignmentsOfSoccerVariables() throws IOException {
        StartScript script = read("BeamNoiseXY = 0.0\nAgentRadius=0.4\n");

        assertThat(script.parameters()).containsExactly("BeamNoiseXY=0.0", "AgentRadius=0.4");
    }

    @Test
    void readsPortsAndModes() throws IOException {
        StartScript script = read("""
                $agentPort = 3500
                $serverPort = 3600
                $agentSyncMode = true
                $enableRealTimeMode = false
                """);

        assertThat(script.agentPort()).contains(3500);
        assertThat(script.monitorPort()).contains(3600);
        assertThat(script.isSynchronous()).isTrue();
        assertThat(script.isFast()).isTrue();
    }

    @Test
    void emptyScriptChangesNothing() throws IOException {
        StartScript script = read("# only a comment\n\n");

        assertThat(script.agentPort()).isEmpty();
        assertThat(script.isSynchronous()).isFalse();
        assertThat(script.isFast()).isFalse();
        assertThat(script.parameters()).isEmpty();
        assertThat(told).isEmpty();
    }

    @Test
    void tellsHowManyLinesItLeavesOut() throws IOException {
        StartScript script = read("run 'naosoccersim.rb'\nif x then\nRuleHalfTime = 60\n");

        assertThat(script.parameters()).containsExactly("RuleHalfTime=60");
        assertThat(told).singleElement().asString().contains("2 lines were left out");
    }

    @Test
    void missingScriptIsNamed() {
        assertThatThrownBy(() -> StartScript.read(folder.resolve("none.rb"), told::add))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("none.rb cannot be read");
    }

    @Test
    void portThatIsNoNumberIsNamed() throws IOException {
        StartScript script = read("$agentPort = many\n");

        assertThatThrownBy(script::agentPort).hasMessageContaining("$agentPort to many, which is not a port number");
    }

    private StartScript read(String text) throws IOException {
        return StartScript.read(Files.writeString(folder.resolve("start.rb"), text), told::add);
    }
}
