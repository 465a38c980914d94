package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** How long a program keeps the world waiting. */
class TurnsTest {

    private final Turns turns = new Turns();
    private double clock;
    private double processor;

    @Test
    void sleepCountsByTheClock() {
        look(0, 0, false);

        look(3, 0, false);
        look(4, 0, false);

        assertThat(turns.waitedSeconds()).isEqualTo(7);
        assertThat(turns.sleptSeconds()).isEqualTo(7);
    }

    @Test
    void calculationCountsByTheProcessorsTimeHoweverLongOthersHaveIt() {
        look(0, 0, true);

        look(1000, 0, true);
        look(1000, 2, false);
        look(1000, 1, true);

        assertThat(turns.waitedSeconds()).isEqualTo(3);
        assertThat(turns.sleptSeconds()).isZero();
    }

    @Test
    void eachTurnBeginsWithNothing() {
        look(0, 0, false);
        look(5, 0, false);
        turns.next();
        look(5, 0, false);
        double onWorldsTurn = turns.waitedSeconds();
        turns.next();

        look(1, 0, false);
        double atFirst = turns.waitedSeconds();
        look(2, 0, false);

        assertThat(onWorldsTurn).isZero();
        assertThat(atFirst).isZero();
        assertThat(turns.waitedSeconds()).isEqualTo(2);
        assertThat(turns.sleptSeconds()).isEqualTo(7);
    }

    /** Looks after some time, in which the program has calculated for a while. */
    private void look(double seconds, double calculated, boolean atWork) {
        clock += seconds;
        processor += calculated;
        turns.look(clock, processor, atWork);
    }
}
