package org.robonewbie.exercises.marking;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SourceShapeTest {

    private static final SourceShape NOTHING = SourceShape.of("");

    private static final String PROGRAM = """
            import org.robonewbie.agent.Agent;

            /** Raises both arms. */
            public class RaiseArms extends Agent {
                private static final double GOAL = 60;
                private int cycles;

                @Override
                protected void think() {
                    cycles++; // counts
                    hold(Joint.LEFT_SHOULDER_PITCH, GOAL);
                    hold(Joint.RIGHT_SHOULDER_PITCH, 45);
                    if (cycles > 100) {
                        log.info("done after " + cycles);
                    }
                }

                private void hold(Joint joint, double degrees) {
                    double error = degrees - nao.getJointAngle(joint);
                    nao.setJointSpeed(joint, 4 * error);
                }
            }
            """;

    private static double likeness(String one, String other) {
        return SourceShape.of(one).similarityTo(SourceShape.of(other), NOTHING);
    }

    @Test
    void copyWithOtherNamesCommentsLayoutAndNumbersIsRecognised() {
        String disguised = PROGRAM.replace("cycles", "zaehler")
                .replace("hold", "stelle")
                .replace("degrees", "winkel")
                .replace("error", "fehler")
                .replace("GOAL", "ZIEL")
                .replace("60", "61.5")
                .replace("// counts", "/* something\n else */")
                .replace("    ", "\t")
                .replace(" {\n", "\n{\n");

        assertThat(likeness(PROGRAM, disguised)).isEqualTo(1);
        assertThat(SourceShape.of(PROGRAM).sameNumbers(SourceShape.of(disguised)))
                .isEqualTo(0.75);
    }

    @Test
    void longTextsAndNumbersOverflowNoStack() {
        String program = "class Long { String text = \"" + "a\\\\".repeat(50_000) + "\"; char c = '"
                + "x".repeat(50_000) + "'; double number = 1" + "0".repeat(50_000) + "; }";

        assertThat(SourceShape.of(program).numbers()).hasSize(1);
    }

    @Test
    void methodsThatChangePlacesDoNotHide() {
        int hold = PROGRAM.indexOf("    private void hold");
        int think = PROGRAM.indexOf("    @Override");
        String turned = PROGRAM.substring(0, think)
                + PROGRAM.substring(hold, PROGRAM.length() - 2)
                + PROGRAM.substring(think, hold)
                + "}\n";

        assertThat(likeness(PROGRAM, turned)).isGreaterThan(0.8);
    }

    @Test
    void anotherSolutionOfTheSameTaskIsNoCopy() {
        String other = """
                import org.robonewbie.agent.Agent;

                public class RaiseArms extends Agent {
                    @Override
                    protected void think() {
                        double left = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
                        double right = nao.getJointAngle(Joint.RIGHT_SHOULDER_PITCH);
                        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, left < 60 ? 30 : 0);
                        nao.setJointSpeed(Joint.RIGHT_SHOULDER_PITCH, right < 45 ? 30 : 0);
                    }
                }
                """;

        assertThat(likeness(PROGRAM, other)).isLessThan(0.3);
    }

    @Test
    void whatEverybodyGotDoesNotCount() {
        SourceShape given = SourceShape.of(PROGRAM);

        assertThat(given.ownRuns(given)).isZero();
        assertThat(given.similarityTo(given, given)).isZero();
    }

    @Test
    void namesOfTheFrameworkTellProgramsApart() {
        assertThat(likeness(PROGRAM, PROGRAM.replace("setJointSpeed", "setJointAngle")))
                .isLessThan(1);
    }

    @Test
    void nonsenseIsReadToo() {
        assertThat(SourceShape.of("/* never ends \" ' \\ \u0000 @ #").runs()).isEmpty();
    }
}
