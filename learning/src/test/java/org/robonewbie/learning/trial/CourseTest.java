package org.robonewbie.learning.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

class CourseTest {

    @Test
    void isTheSameEachTimeForTheSameSeed() {
        Course first = walked(7);
        Course second = walked(7);

        assertThat(second.forward()).isEqualTo(first.forward());
        assertThat(second.left()).isEqualTo(first.left());
        assertThat(second.turnedDegrees()).isEqualTo(first.turnedDegrees());
    }

    @Test
    void differsWithTheSeed() {
        assertThat(walked(8).left()).isNotEqualTo(walked(7).left());
    }

    @Test
    void beginsInTheStance() {
        Course course = new Course(3, 0);

        assertThat(course.endsInStance()).isTrue();
        assertThat(course.forward()).isCloseTo(0, within(0.005));
    }

    @Test
    void findsPlacesAsTheRobotSeesThem() {
        Course course = new Course(3, 0);

        Vector3 seen = course.seen(course.place(1, 0.5, 0.042));

        assertThat(seen.x()).isCloseTo(1, within(1e-9));
        assertThat(seen.y()).isCloseTo(0.5, within(1e-9));
    }

    private static Course walked(long seed) {
        Course course = new Course(seed, 5);
        Motion walk = ShippedMotions.motion("walk-forward");
        course.play(walk);
        course.play(walk);
        return course;
    }
}
