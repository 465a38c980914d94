package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.programs.completion.Proposal;

/** What the compiler says about a program that is being written, and what it proposes. */
class CompletionTest {

    private static final String BEGIN = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class MyAgent extends Agent {
                /** How high the arm goes. */
                private int heightOfArm() {
                    return 3;
                }

                @Override
                protected void think() {
                    String word = "x";
            """;
    private static final String END = """

                }
            }
            """;

    @TempDir
    private Path folder;

    private List<Remark> check(String line) {
        return JavaSource.of(folder.resolve("MyAgent.java"), BEGIN + line + END).check(List.of(folder));
    }

    private List<Proposal> complete(String line) {
        return JavaSource.of(folder.resolve("MyAgent.java"), BEGIN + line + END)
                .complete(List.of(folder), (BEGIN + line).length());
    }

    @Test
    void correctProgramGetsNoRemark() {
        assertThat(check("nao.setJointSpeed(Joint.NECK_YAW, 10);")).isEmpty();
    }

    @Test
    void mistakeHasItsPlaceTheCompilersWordsAndWhatToDo() {
        List<Remark> remarks = check("int angle = 30.5;");

        assertThat(remarks).singleElement().satisfies(remark -> {
            assertThat(remark.line()).isEqualTo(13);
            assertThat((BEGIN + "int angle = 30.5;").substring((int) remark.from(), (int) remark.to()))
                    .isEqualTo("30.5");
            assertThat(remark.text()).contains("possible lossy conversion from double to int");
            assertThat(remark.hint()).contains("(int)");
        });
    }

    @Test
    void misspelledNameOfTheFrameworkIsRecognised() {
        assertThat(check("nao.setJointSped(Joint.NECK_YAW, 10);"))
                .extracting(Remark::hint)
                .containsExactly("Did you mean setJointSpeed?");
        assertThat(check("Vector3 place;"))
                .extracting(Remark::hint)
                .containsExactly("Add at the top of the file: import org.robonewbie.nao.Vector3;");
    }

    @Test
    void otherFilesOfTheFolderAreKnown() throws IOException {
        Files.writeString(folder.resolve("Arm.java"), "class Arm { static int raise() { return 1; } }");

        assertThat(check("int n = Arm.raise();")).isEmpty();
        assertThat(complete("Arm.")).extracting(Proposal::label).contains("raise");
    }

    @Test
    void membersOfWhatStandsBeforeTheDotAreProposed() {
        assertThat(complete("nao.setJoint")).extracting(Proposal::label).contains("setJointSpeed");
        assertThat(complete("nao.setJoint"))
                .allSatisfy(each -> assertThat(each.label()).startsWith("setJoint"));
        assertThat(complete("word.len")).extracting(Proposal::insert).containsExactly("length()");
        assertThat(complete("Joint.NECK_Y")).extracting(Proposal::kind).containsExactly("constant");
    }

    @Test
    void proposalSaysParametersTypeAndDocumentationOfOwnMethods() {
        assertThat(complete("heightO")).singleElement().satisfies(proposal -> {
            assertThat(proposal.detail()).isEqualTo("() int");
            assertThat(proposal.documentation()).isEqualTo("How high the arm goes.");
        });
    }

    @Test
    void proposalOfTheFrameworkIsDocumented() {
        assertThat(complete("nao.setJointSpeed")).anySatisfy(proposal -> {
            assertThat(proposal.detail()).isEqualTo("(Joint joint, double degreesPerSecond) void");
            assertThat(proposal.insert()).isEqualTo("setJointSpeed(");
            assertThat(proposal.documentation()).contains("degreesPerSecond: ");
        });
    }

    @Test
    void unfinishedProgramIsReadAsWellAsPossible() {
        String text = BEGIN + "if (word.";

        List<Proposal> proposals =
                JavaSource.of(folder.resolve("MyAgent.java"), text).complete(List.of(folder), text.length());

        assertThat(proposals).extracting(Proposal::label).contains("isEmpty");
    }
}
