package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HelpExamplesTest {

    private final HelpExamples examples = new HelpExamples(new ProgramName("./robonewbie"), 50);

    @Test
    void shortExampleStaysAsItIs() {
        assertThat(examples.text("  robonewbie doctor     checks").lines())
                .containsExactly("  ./robonewbie doctor     checks");
    }

    @Test
    void longExampleHasItsExplanationFartherRightInTheNextLine() {
        assertThat(examples.text("  robonewbie grade kick Kick.java   and what it means")
                        .lines())
                .containsExactly("  ./robonewbie grade kick Kick.java", "      and what it means");
    }

    @Test
    void longCommandContinuesFartherRight() {
        assertThat(examples.text("  robonewbie optimise my-walk.txt --objective walk-speed --resume")
                        .lines())
                .containsExactly("  ./robonewbie optimise my-walk.txt --objective", "      walk-speed --resume");
    }

    @Test
    void textThatIsNoExampleBreaksBetweenWords() {
        assertThat(examples.text("", "Exit code: 0 passed, 1 not yet passed, 2 called incorrectly, and no more")
                        .lines())
                .containsExactly("", "Exit code: 0 passed, 1 not yet passed, 2 called", "incorrectly, and no more");
    }
}
