package org.robonewbie.simulator.physics.sparse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;

class SymbolicFactorizationCacheTest {

    private final SymbolicFactorizationCache cache = new SymbolicFactorizationCache();

    /** A joint that is known by its bodies and rows only. */
    private static final class Link extends ConstraintJoint {

        private final int rows;

        Link(Body first, Body second, int rows) {
            super(first, second, false);
            this.rows = rows;
        }

        @Override
        int rowCount() {
            return rows;
        }

        @Override
        void writeRows(ConstraintRows target, double rate) {}
    }

    @Test
    void sameJointsHaveTheSamePlan() {
        SymbolicFactorization factorization = cache.get(chain(20, 6), 21);
        cache.get(chain(20, 5), 21);

        assertThat(cache.get(chain(20, 6), 21)).isSameAs(factorization);
    }

    @Test
    void manyPlansTakeNoMoreThanAMegabyte() {
        for (int length = 1; length <= 400; length++) {
            cache.get(chain(length, 3), length + 1);
        }

        assertThat(cache.memoryInInts()).isBetween(100_000, 1 << 18);
    }

    @Test
    void theLargePlanOfAPileDrivesAwayOnlyTheOneBefore() {
        SymbolicFactorization small = cache.get(chain(20, 6), 21);

        SymbolicFactorization pile = cache.get(star(80), 81);
        SymbolicFactorization pileAtRest = cache.get(star(80), 81);
        long made = cache.misses();
        cache.get(star(81), 82);
        cache.get(star(80), 81);

        assertThat(pileAtRest).isSameAs(pile);
        assertThat(cache.misses()).isEqualTo(made + 2);
        assertThat(cache.get(chain(20, 6), 21)).isSameAs(small);
    }

    @Test
    void theLargePlanIsForgottenWhenThePileIsGone() {
        cache.get(star(80), 81);
        List<ConstraintJoint> single = chain(20, 6);

        for (int i = 0; i < 60_000; i++) {
            cache.get(single, 21);
        }

        long made = cache.misses();
        cache.get(star(80), 81);
        assertThat(cache.misses()).isEqualTo(made + 1);
    }

    @Test
    void aPlanThatIsMadeAnewIsAsGoodAsANewOne() {
        for (int length = 300; length > 250; length--) {
            cache.get(star(length % 7 + 80), 87);
            SymbolicFactorization again = cache.get(chain(length, 3), length + 1);
            SymbolicFactorization fresh = new SymbolicFactorizationCache().get(chain(length, 3), length + 1);

            assertThat(again.rows()).isEqualTo(fresh.rows());
            assertThat(again.size()).isEqualTo(fresh.size());
            assertThat(again.overlapsEnd).isEqualTo(fresh.overlapsEnd);
            assertThat(again.order).startsWith(Arrays.copyOf(fresh.order, length));
            assertThat(again.updates).startsWith(Arrays.copyOf(fresh.updates, fresh.updatesStart[length]));
            assertThat(again.overlaps).startsWith(Arrays.copyOf(fresh.overlaps, fresh.overlapsEnd));
        }
    }

    private static List<ConstraintJoint> chain(int length, int rows) {
        List<Body> bodies = bodies(length + 1);
        List<ConstraintJoint> joints = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            joints.add(new Link(bodies.get(i), bodies.get(i + 1), rows));
        }
        return joints;
    }

    /** All joints hold the same body, so that each is coupled with each. */
    private static List<ConstraintJoint> star(int size) {
        List<Body> bodies = bodies(size + 1);
        List<ConstraintJoint> joints = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            joints.add(new Link(bodies.get(0), bodies.get(i + 1), 3));
        }
        return joints;
    }

    private static List<Body> bodies(int count) {
        List<Body> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Body body = new Body(new MassDistribution(1, new Vector3(1, 1, 1)), Vector3.ZERO, new UpdateSequence());
            body.islandIndex = i;
            bodies.add(body);
        }
        return bodies;
    }
}
