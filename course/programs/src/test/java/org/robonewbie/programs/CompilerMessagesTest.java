package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CompilerMessagesTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    nao.getJointAngle(Joint.LEFT_KNEE);                                            | LEFT_KNEE_PITCH
                    nao.getJointAngle(Joint.HEAD_YAW);                                             | NECK_YAW
                    switch (nao.getBodyPosition()) { case ON_BACK: break; default: break; }        | LYING_ON_BACK
                    nao.setJointSped(Joint.NECK_YAW, 3);                                           | setJointSpeed
                    """)
    void misspeltNameOfTheFrameworkIsToldWithTheOneThatWasMeant(String line, String meant) throws IOException {
        assertThat(messagesFor("import org.robonewbie.nao.Joint;", line)).contains("Did you mean " + meant + "?");
    }

    @Test
    void missingImportIsToldOnceHoweverOftenTheNameIsUsed() throws IOException {
        String messages = messagesFor("", "nao.setJointSpeed(Joint.NECK_YAW, nao.getJointAngle(Joint.NECK_YAW));");

        assertThat(messages)
                .contains("1 error\n", "Add at the top of the file:")
                .containsOnlyOnce("  import org.robonewbie.nao.Joint;")
                .doesNotContain("Did you mean");
    }

    @Test
    void mistakesThatOnlyFollowFromAMissingImportAreLeftOut() throws IOException {
        Path file = Files.writeString(folder.resolve("NoImport.java"), """
                public class NoImport extends Agent {
                    public static void main(String[] args) { new NoImport().run(args); }
                    protected void think() { nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 60); }
                }
                """);

        assertThat(messagesFor(file))
                .contains("import org.robonewbie.agent.Agent;", "import org.robonewbie.nao.Joint;", "2 errors")
                .doesNotContain("Did you mean", "symbol:   method run", "symbol:   variable nao");
    }

    @ParameterizedTest
    @ValueSource(strings = {"import java.util.Scaner;", "import java.utl.Scanner;", ""})
    void otherUnknownClassIsToldTooAndOnlyOnce(String imports) throws IOException {
        String joint = imports.isEmpty() ? "Joint joint; " : "";

        String messages = messagesFor(imports, joint + "Thraed.sleep(5); Thraed one; new Tiemr(); tiemr();");

        assertThat(messages)
                .contains("3 errors", "Thraed", "symbol:   class Tiemr")
                .doesNotContain("method tiemr");
    }

    @Test
    void classesOfAMisspeltPackageAreLeftOut() throws IOException {
        assertThat(messagesFor("import java.utl.*;", "Scanner one; Timer other;"))
                .contains("1 error\n");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    org.robonewbie.agnet.Agent       | org.robonewbie.agent.Agent
                    org.robonewby.agent.Robot        | org.robonewbie.agent.Robot
                    org.robonewbie.agent.Joint       | org.robonewbie.nao.Joint
                    org.robonewbie.nao.Jiont         | Joint
                    org.robonewbie.nao.motions.Jump  | org.robonewbie.nao.motion.Jump
                    java.utl.ArrayList               | java.util.ArrayList
                    java.utils.*                     | java.util.*
                    """)
    void misspeltImportIsToldWithTheOneThatWasMeant(String written, String meant) throws IOException {
        String type = written.endsWith("*") ? "ArrayList" : written.substring(written.lastIndexOf('.') + 1);

        String messages = messagesFor("import " + written + ";", type + " thing; " + type + " other;");

        assertThat(messages)
                .contains("1 error\n", "Did you mean " + meant + "?")
                .doesNotContain("Add at the top");
    }

    @Test
    void aMisspeltVariableIsNotTakenForAnImport() throws IOException {
        assertThat(messagesFor("", "system.out.println(1); int x = nao.getTime();"))
                .contains("2 errors")
                .doesNotContain("Check the spelling of the import");
    }

    @Test
    void classThatTheCompilerTakesForAPackageIsKnown() throws IOException {
        assertThat(messagesFor("", "Vector3.ZERO.length();"))
                .contains("Add at the top of the file: import org.robonewbie.nao.Vector3;");
        assertThat(messagesFor("", "Vektor3.ZERO.length();")).contains("Did you mean Vector3?");
    }

    @Test
    void methodsOfTheClassItselfAreOfferedWhereNothingIsSimilar() throws IOException {
        String imports = "import org.robonewbie.nao.Joint; import org.robonewbie.nao.motion.Posture;";

        String messages = messagesFor(imports, "double angle = Posture.ZERO.get(Joint.NECK_YAW);");

        assertThat(messages)
                .contains("Posture has the methods clamped, degrees,")
                .doesNotContain("Did you mean");
    }

    @Test
    void methodOfTheVariablesTypeIsMeantAndNotThatOfAnotherOne() throws IOException {
        assertThat(messagesFor("", "double way = fieldView.ball().distanc();")).contains("Did you mean distance?");
        assertThat(messagesFor("", "motions.performs(\"wave\");")).doesNotContain("Did you mean perform?");
    }

    private String messagesFor(String imports, String line) throws IOException {
        Path file = Files.writeString(
                folder.resolve("Walker.java"),
                imports + "public class Walker extends org.robonewbie.agent.Agent {"
                        + " @Override protected void think() { " + line + " } }");
        return messagesFor(file);
    }

    private String messagesFor(Path file) throws IOException {
        CompilerMessages messages = new CompilerMessages();
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        var compiler = ToolProvider.getSystemJavaCompiler();
        try (var disk = compiler.getStandardFileManager(null, null, null)) {
            List<String> options =
                    List.of("-proc:none", "-d", folder.toString(), "-cp", System.getProperty("java.class.path"));
            compiler.getTask(null, disk, messages, options, null, disk.getJavaFileObjects(file))
                    .call();
        }
        messages.print(new PrintStream(printed, true, StandardCharsets.UTF_8));
        return printed.toString(StandardCharsets.UTF_8);
    }
}
