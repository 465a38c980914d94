package org.robonewbie.web.library;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class SplittableRandomTest {

    private static final int MANY = 200;

    @Test
    void seedGivesTheNumbersOfJavaAlsoBehindSplits() {
        SplittableRandom java = new SplittableRandom(-42);
        var own = new org.robonewbie.web.library.java.util.SplittableRandom(-42);

        for (int i = 0; i < MANY; i++) {
            assertThat(own.nextDouble()).isEqualTo(java.nextDouble());
            SplittableRandom javas = java.split();
            var ours = own.split();
            assertThat(LongStream.generate(ours::nextLong).limit(5))
                    .containsExactly(LongStream.generate(javas::nextLong)
                            .limit(5)
                            .boxed()
                            .toArray(Long[]::new));
        }
    }
}
