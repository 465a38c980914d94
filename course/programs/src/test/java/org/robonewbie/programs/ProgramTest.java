package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@SuppressWarnings("IncorrectProgram")
class ProgramTest {

    private static final List<String> CALLS = new ArrayList<>();

    static class Classic {
        public static void main(String[] args) {
            CALLS.add("classic " + args.length);
        }
    }

    static class Instance {
        void main() {
            CALLS.add("instance");
        }
    }

    static class WithArguments {
        void main() {
            CALLS.add("without");
        }

        @SuppressWarnings("IncorrectProgram")
        protected void main(String[] args) {
            CALLS.add("with " + args[0]);
        }
    }

    static class StaticWithoutModifier {
        static void main() {
            CALLS.add("static");
        }
    }

    static class Hidden {
        @SuppressWarnings("UnusedMethod") // that is what is tried
        private void main() {
            CALLS.add("hidden");
        }
    }

    static class WithoutConstructor {
        private final int number;

        WithoutConstructor(int number) {
            this.number = number;
        }

        void main() {
            CALLS.add("number " + number);
        }
    }

    @Test
    void shortFormsBeginFromJava25On() throws Exception {
        CALLS.clear();
        for (Class<?> type : List.of(Classic.class, Instance.class, WithArguments.class, StaticWithoutModifier.class)) {
            Program.of(type, 25).orElseThrow().call("a", "b");
        }

        assertThat(CALLS).containsExactly("classic 2", "instance", "with a", "static");
    }

    @ParameterizedTest
    @ValueSource(classes = {Instance.class, WithArguments.class, StaticWithoutModifier.class})
    void olderJavaDoesNotBeginWithThemAndCanSayWhy(Class<?> type) {
        assertThat(Program.of(type, 17)).isEmpty();
        assertThat(Program.of(type, 24)).isEmpty();
        assertThat(Program.isShort(type)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(classes = {Hidden.class, WithoutConstructor.class, String.class})
    void whatNoJavaBeginsWithIsNone(Class<?> type) {
        assertThat(Program.isShort(type)).isFalse();
    }
}
