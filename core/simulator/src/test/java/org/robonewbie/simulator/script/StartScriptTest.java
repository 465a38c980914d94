package org.robonewbie.simulator.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.file.UnreadableFileException;

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
    void calculatesAsRubyDoes() throws IOException {
        StartScript script = read("""
                addSoccerVar('RuleHalfTime', 10.0 * 60)
                addSoccerVar('FieldLength', 24.0); addSoccerVar('FieldWidth', (7 + 7) * 1.0);
                $agentPort = 3811;
                addSoccerVar("WaitBeforeKickOff", 1_000)
                minutes = 5
                addSoccerVar('RuleKickInPauseTime', minutes * 7 / 4 - -1)
                addSoccerVar(
                  'RuleGoalPauseTime',
                  2 ** 3 % 5 +
                  0x10
                )
                addSoccerVar :FreeKickDistance, 017
                createVariable 'Soccer.GoalDepth', 6e-1
                """);

        assertThat(script.parameters())
                .containsExactly(
                        "RuleHalfTime=600.0",
                        "FieldLength=24.0",
                        "FieldWidth=14.0",
                        "WaitBeforeKickOff=1000",
                        "RuleKickInPauseTime=9",
                        "RuleGoalPauseTime=19",
                        "FreeKickDistance=15",
                        "GoalDepth=0.6");
        assertThat(script.agentPort()).contains(3811);
        assertThat(told).isEmpty();
    }

    @Test
    void ignoresCommentsAndStrings() throws IOException {
        StartScript script = read("""
                =begin
                addSoccerVar('FieldLength', 99)
                =end
                puts "# addSoccerVar('FieldLength', 98)" # addSoccerVar('FieldLength', 97)
                x = <<-EOS + 'x'
                addSoccerVar('FieldLength', 96)
                  EOS
                y = %q(
                addSoccerVar('FieldLength', 95))
                addSoccerVar('FieldWidth', 14) # '
                __END__
                addSoccerVar('FieldLength', 94)
                """);

        assertThat(script.parameters()).containsExactly("FieldWidth=14");
        assertThat(told).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "if false\\nSET\\nend | it is in the \"if\" of line 1",
                "def f\\nSET\\nend | it is in the \"def\" of line 1",
                "unless true then\\nSET\\nend | it is in the \"unless\" of line 1",
                "[1].each do\\nSET\\nend | it is in the \"do\" of line 1",
                "3.times {\\nSET\\n} | it is in the \"{\" of line 1",
                "x = 1 if y\\nSET if x | it depends on a condition",
                "class A\\n SET\\nend | it is in the \"class\" of line 1",
                "exit\\nSET | the script ends earlier, at \"exit\" in line 1",
                "\\naddSoccerVar('RuleHalfTime', foo(3)) | its value cannot be evaluated",
                "\\naddSoccerVar('RuleHalfTime', .9) | its value cannot be evaluated",
                "\\nx.each { addSoccerVar('RuleHalfTime', 3) } | it is in the \"{\" of line 2"
            })
    void reportsSettingsThatRubyMayNotExecute(String text, String reason) throws IOException {
        String setting = "addSoccerVar('RuleHalfTime', 1)";

        StartScript script = read(text.replace("\\n", "\n").replace("SET", setting));

        assertThat(script.parameters()).isEmpty();
        assertThat(told)
                .singleElement()
                .asString()
                .contains("start.rb, line 2: ")
                .contains(" is ignored: " + reason);
    }

    @Test
    void blocksEndWhereRubyEndsThem() throws IOException {
        StartScript script = read("""
                def end_of(x) = x
                class Foo
                  def x=(v)
                    @x = v if v
                  end
                  def self.if; end
                end
                while false do x end
                y = if true then 1 else 2 end
                z = { if: 1, end: 2 }
                case 3
                when 3 then 4
                end
                3.times { |i| i } if false
                a = 8
                b = a /2
                addSoccerVar('RuleHalfTime', b) # /
                """);

        assertThat(script.parameters()).containsExactly("RuleHalfTime=4");
        assertThat(told).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "addSoccerVar(\"GoalWidht\", 3) | there is no parameter GoalWidht. Did you mean GoalWidth?",
                "RuleHalftime = 60 | there is no parameter RuleHalftime. Did you mean RuleHalfTime?",
                "ruleHalfTime = 60 | there is no parameter ruleHalfTime. Did you mean RuleHalfTime?",
                "$agentport = 3100 | there is no such setting here. Did you mean $agentPort?",
                "$recordLogfile = true | use the option --log FILE.",
                "$monitorStep=0.08 | use the option --monitor-step 0.08.",
                "$agentStep = 0.02 | a cycle is always 0.02 s long here.",
                "run 'naosoccersim.rb' | it is a script of rcssserver3d, which is not needed here.",
                "run \"my.rb\" | there is no file my.rb beside the script or in the folder ",
                "run \"a#{b}.rb\" | the name of the script cannot be evaluated.",
                "Soccer.GoalWidth=2.5 | it is not a plain setting. Write addSoccerVar('GoalWidth', VALUE)"
            })
    void reportsIgnoredSettingsWithTheirLine(String line, String reason) throws IOException {
        StartScript script = read("\n" + line + "\n");

        assertThat(script.parameters()).isEmpty();
        assertThat(told)
                .singleElement()
                .asString()
                .contains("start.rb, line 2: ")
                .contains(" is ignored: " + reason);
    }

    @Test
    void otherRubyNeedsNoWord() throws IOException {
        read("sparkLogAllToCerr\nimportBundle 'soccer'\nscene = get($scenePath)\nscene.run 'x'\nx == 3\n");

        assertThat(told).isEmpty();
    }

    @Test
    void manyLinesAreCounted() throws IOException {
        read("$no = 1\n".repeat(60));

        assertThat(told).hasSize(41).last().isEqualTo("20 more lines are ignored.");
    }

    @Test
    void followsScriptsBesideIt() throws IOException {
        Files.createDirectories(folder.resolve("rules"));
        Files.writeString(folder.resolve("rules/soccer.rb"), "FieldLength = 24.0\nrun '../start.rb'\nrun 'goal.rb'\n");
        Files.writeString(folder.resolve("rules/goal.rb"), "addSoccerVar('GoalWidth', half * 2)");

        StartScript script = read("half = 1.5\nrun \"rules/soccer.rb\"\nrequire_relative 'rules/goal'\n");

        assertThat(script.parameters()).containsExactly("FieldLength=24.0", "GoalWidth=3.0");
        assertThat(told).singleElement().asString().contains("soccer.rb, line 2: ", "would run itself");
    }

    @Test
    void scriptsThatRunEachOtherEnd() throws IOException {
        for (int i = 0; i < 20; i++) {
            Files.writeString(folder.resolve(i + ".rb"), ("run '" + (i + 1) + ".rb'\n").repeat(2));
        }

        assertThatThrownBy(() -> read("run '0.rb'"))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("More than 50 scripts");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "$agentPort = \"many\" | The script sets $agentPort to many, which is not a port number",
                "$agentPort = 99999 | The script sets $agentPort to 99999, which is not a port number",
                "$agentSyncMode = 1 | The script sets $agentSyncMode to 1, which is neither true nor false",
                "addSoccerVar(:FieldLength, -3) | Value -3 of FieldLength is too small."
            })
    void impossibleValueIsRefusedWithItsLine(String line, String message) {
        assertThatThrownBy(() -> read("\n" + line))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("start.rb, line 2: " + message);
    }

    @ParameterizedTest
    @CsvSource({"UTF-8, '', '\n'", "UTF-8, '\uFEFF', '\r\n'", "UTF-16LE, '\uFEFF', '\r\n'", "windows-1252, '', '\r'"})
    void scriptOfAnyEditorIsRead(String encoding, String mark, String end) throws IOException {
        String text = mark + String.join(end, "addSoccerVar('FieldLength', 24.0)", "# größe", "$agentPort = 3811", "");
        Path file = Files.write(folder.resolve("start.rb"), text.getBytes(Charset.forName(encoding)));

        StartScript script = StartScript.read(file, told::add);

        assertThat(script.parameters()).containsExactly("FieldLength=24.0");
        assertThat(script.agentPort()).contains(3811);
        assertThat(told).isEmpty();
    }

    @Test
    void fileThatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("start.rb"), new byte[] {1, 2, 0, (byte) 0x81});

        assertThatThrownBy(() -> StartScript.read(file, told::add))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageStartingWith("The file " + file + " cannot be read: line 1 ");
    }

    @Test
    void unterminatedStringIsReported() throws IOException {
        assertThat(read("FieldLength = 24\nputs 'x\nGoalWidth = 3").parameters())
                .containsExactly("FieldLength=24");
        assertThat(told)
                .singleElement()
                .asString()
                .contains("start.rb, line 2: a string starts here and is not terminated");
    }

    @Test
    void bracketsInBracketsEndSomewhere() throws IOException {
        read("FieldLength = " + "(".repeat(100_000) + "\n");

        assertThat(told).hasSize(1);
    }

    @Test
    void folderIsRefusedWithAListOfItsScripts() throws IOException {
        assertThatThrownBy(() -> StartScript.read(folder, told::add))
                .hasMessageContaining("is a folder. Choose a file in it, such as ");
        Files.writeString(folder.resolve("match.rb"), "");
        assertThatThrownBy(() -> StartScript.read(folder, told::add))
                .hasMessageContaining("is a folder. Choose a file in it; it contains match.rb.");
    }

    @Test
    void missingScriptIsReported() {
        assertThatThrownBy(() -> StartScript.read(folder.resolve("none.rb"), told::add))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("none.rb does not exist");
    }

    private StartScript read(String text) throws IOException {
        return StartScript.read(Files.writeString(folder.resolve("start.rb"), text), told::add);
    }
}
