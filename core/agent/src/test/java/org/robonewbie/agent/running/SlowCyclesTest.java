package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.running.StackSample.Kind;

class SlowCyclesTest {

    private static final StackSample SLEEP = new StackSample(Kind.SLEEPS, "Thread.sleep()", "A.java:9");

    private final SlowCycles cycles = new SlowCycles();
    private final List<Slowness> found = new ArrayList<>();

    @Test
    void findsASleepInTheThirdThought() {
        sleep(500);
        sleep(501);
        assertThat(found).isEmpty();
        sleep(502);

        assertThat(found).containsExactly(new Slowness(SLEEP, 501));
    }

    @Test
    void namesTheUsualTimeWhenOneOfThemWasStoppedByADebugger() {
        sleep(60_000);
        sleep(100);
        sleep(101);

        assertThat(found).singleElement().extracting(Slowness::milliseconds).isEqualTo(101.0);
    }

    @Test
    void findsASleepInEachTenthThought() {
        for (int i = 0; i < 3; i++) {
            sleep(20);
            quick(9);
        }

        assertThat(found).hasSize(1);
    }

    @Test
    void forgivesWaitingThatIsRare() {
        for (int i = 0; i < 20; i++) {
            sleep(20);
            quick(49);
        }

        assertThat(found).isEmpty();
    }

    @Test
    void forgivesTheFirstCyclesOfJava() {
        for (int i = 0; i < 4; i++) {
            compute("B.java:1", 400);
        }
        quick(1000);

        assertThat(found).isEmpty();
    }

    @Test
    void forgivesCyclesThatTakeLongerOnlyOnABusyComputer() {
        for (int i = 0; i < 100; i++) {
            cycles.sample(new StackSample(Kind.COMPUTES, "", "B.java:1"), 5);
            ends(300);
        }

        assertThat(found).isEmpty();
    }

    @Test
    void forgivesWorkOfTheFrameworkAlone() {
        for (int i = 0; i < 100; i++) {
            compute("", 400);
        }

        assertThat(found).isEmpty();
    }

    @Test
    void namesTheLineThatComputesMost() {
        for (int i = 0; i < 5; i++) {
            cycles.sample(new StackSample(Kind.COMPUTES, "", "B.java:1"), 0);
            compute(i == 2 ? "B.java:7" : "B.java:4", 300);
        }

        assertThat(found).containsExactly(new Slowness(new StackSample(Kind.COMPUTES, "", "B.java:4"), 300));
    }

    @Test
    void tellsSleepingFromComputingByWhatTakesMore() {
        for (int i = 0; i < 3; i++) {
            cycles.sample(new StackSample(Kind.COMPUTES, "", "B.java:4"), 10);
            cycles.sample(SLEEP, 0);
            sleep(30);
        }

        assertThat(found).singleElement().matches(Slowness::isIdle);
    }

    @Test
    void saysWhatToDoInsteadOfWaiting() {
        Slowness reading = new Slowness(new StackSample(Kind.WAITS, "Scanner.nextLine()", "A.java:3"), 2000);

        assertThat(sentence(CycleOwner.FRAMEWORK, new Slowness(SLEEP, 500)))
                .isEqualTo("think() slept 500 ms; it is called 50 times per simulated second. Count cycles or compare"
                        + " nao.getTime() instead.");
        assertThat(sentence(CycleOwner.PROGRAM, new Slowness(SLEEP, 100)))
                .isEqualTo("The program slept 100 ms; sense() must be called 50 times per simulated second. Count"
                        + " cycles or compare nao.getTime() instead.");
        assertThat(sentence(CycleOwner.FRAMEWORK, reading))
                .isEqualTo("think() waited 2000 ms in Scanner.nextLine(); it is called 50 times per simulated second."
                        + " Wait in a separate thread, and read only its result.");
    }

    private static String sentence(CycleOwner owner, Slowness slowness) {
        return owner.finding(slowness, "") + " " + slowness.advice();
    }

    private void sleep(double milliseconds) {
        cycles.sample(SLEEP, 0);
        ends(milliseconds);
    }

    private void compute(String place, double milliseconds) {
        StackSample sample = new StackSample(Kind.COMPUTES, "", place);
        cycles.sample(sample, milliseconds / 2);
        cycles.sample(sample, milliseconds / 2);
        ends(milliseconds);
    }

    private void quick(int count) {
        for (int i = 0; i < count; i++) {
            ends(1);
        }
    }

    private void ends(double milliseconds) {
        cycles.cycleEnds(milliseconds).ifPresent(found::add);
    }
}
