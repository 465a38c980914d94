package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;

@SuppressWarnings({"UnusedMethod", "UnusedVariable", "EffectivelyPrivate"})
class ThinkSpellingTest {

    @Test
    void findsTheMethodThatIsSpeltAlmostLikeIt() {
        class Thnik extends Agent {
            protected void thnik() {}
        }
        class Capital extends Agent {
            protected void Think() {}
        }
        class Plural extends Agent {
            private void thinks(int cycle) {}
        }

        assertThat(wrongIn(Thnik.class)).isEqualTo("Thnik has no think(); did you mean thnik()?");
        assertThat(wrongIn(Capital.class)).isEqualTo("Capital has no think(); did you mean Think()?");
        assertThat(wrongIn(Plural.class)).isEqualTo("Plural has no think(); did you mean thinks(int)?");
    }

    @Test
    void explainsThatThinkTakesNothing() {
        class Timed extends Agent {
            protected void think(double seconds) {}
        }

        assertThat(wrongIn(Timed.class))
                .isEqualTo("Timed has no think(); think(double) is never called, since think() has no parameters:"
                        + " remove them.");
    }

    @Test
    void saysWhereARobotWithoutAnythingSimilarBegins() {
        class Empty extends Agent {
            private void walkToTheBall() {}
        }

        assertThat(wrongIn(Empty.class))
                .isEqualTo("Empty has no think(); the robot does nothing. Put its behaviour in: protected void"
                        + " think() { ... }");
    }

    @Test
    void isSilentAboutAProgramThatOverridesAStepItselfOrInherits() {
        class Thinker extends Agent {
            @Override
            protected void think() {}

            void thin() {}
        }
        class Heir extends Thinker {
            void thinks() {}
        }
        class Sensor extends Agent {
            @Override
            protected void sense() {}
        }

        assertThat(wrongIn(Thinker.class)).isEmpty();
        assertThat(wrongIn(Heir.class)).isEmpty();
        assertThat(wrongIn(Sensor.class)).isEmpty();
    }

    private static String wrongIn(Class<?> program) {
        return ThinkSpelling.problemIn(program, Agent.class, program.getSimpleName())
                .orElse("");
    }
}
