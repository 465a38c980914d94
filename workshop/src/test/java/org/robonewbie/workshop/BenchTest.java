package org.robonewbie.workshop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

class BenchTest {

    private final StringWriter out = new StringWriter();
    private final StringWriter errors = new StringWriter();

    static Set<String> subjects() {
        return Bench.commandLine().getSubcommands().keySet();
    }

    @ParameterizedTest
    @MethodSource("subjects")
    void eachSubjectHasItsHelp(String subject) {
        assertThat(bench(subject, "--help")).isZero();
        assertThat(out.toString()).startsWith("Usage: bench " + subject).contains("Example");
    }

    @Test
    void helpListsAllSubjects() {
        assertThat(bench("--help")).isZero();
        assertThat(out.toString())
                .contains(
                        "  motions",
                        "  agents",
                        "  examples",
                        "  team",
                        "  server",
                        "  speed",
                        "  fidelity",
                        "  record",
                        "  sparring");
    }

    @Test
    void helpOfSpeedExplainsHowToMeasureARealServer() {
        bench("speed", "--help");

        assertThat(out.toString()).contains("$agentSyncMode = true", "pidof rcssserver3d");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "agents --seeds 0 | --seeds must be at least 1, not 0.",
                "motions --type 5 | --type must be from 0 to 4, not 5.",
                "examples --seconds 0 | --seconds 0.0 is not valid. Use a number of simulated seconds above 0, such as 20.",
                "examples --only Nobody | No example's name contains \"Nobody\".",
                "team --players 12 | --players must be from 1 to 11, not 12.",
                "team --against Agent_Nobody | --against must be Agent_BetterSoccer or Agent_Team, not Agent_Nobody.",
                "sparring --players 12 | --players must be from 1 to 11, not 12.",
                "sparring --pairs team:nowhere | There is no team \"nowhere\".",
                "server --robots 1 | --robots must be from 2 to 22, not 1.",
                "speed --robots 1,23 | --robots must be from 1 to 22, not 23.",
                "speed --seconds 0 | --seconds 0.0 is not valid. Use a number of simulated seconds above 0, such as 20.",
                "speed --host localhost --port 70000 | --port must be from 1 to 65535, not 70000.",
                "speed --json no/such/folder/figures.json | The results cannot be written to the folder",
                "record --type 7 | --type must be from 0 to 4, not 7.",
                "fidelity nowhere | nowhere is not a folder"
            })
    void refusesWhatCannotBeMeasured(String command, String message) {
        assertThat(bench(command.split(" "))).isEqualTo(CommandLine.ExitCode.USAGE);
        assertThat(errors.toString()).contains(message);
    }

    private int bench(String... arguments) {
        return Bench.commandLine()
                .setOut(new PrintWriter(out, true))
                .setErr(new PrintWriter(errors, true))
                .execute(arguments);
    }
}
