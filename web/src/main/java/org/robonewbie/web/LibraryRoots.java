package org.robonewbie.web;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedList;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Queue;
import org.robonewbie.agent.localisation.Odometry;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.log.LogLevel;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.PoseApproach;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Mirror;

/** Classes that programs of students may use and nothing else in the page does: what is named here gets into the compiled program. */
final class LibraryRoots {

    private static final List<Class<?>> CLASSES = List.of(
            AssertionError.class,
            ClassCastException.class,
            NumberFormatException.class,
            UnsupportedOperationException.class,
            InterruptedException.class,
            ArrayDeque.class,
            Deque.class,
            LinkedList.class,
            PriorityQueue.class,
            Queue.class,
            LogLevel.class,
            LookAround.class,
            LocalFieldView.class,
            PlayerItem.class,
            FastWalk.class,
            PoseApproach.class,
            Odometry.class,
            SelfLocalisation.class,
            Cycle.class,
            TeamSide.class,
            ForwardKinematics.class,
            Leg.class,
            BallPlace.class,
            Mirror.class);

    private LibraryRoots() {}

    /** {@return how many there are} */
    static int count() {
        return CLASSES.size();
    }
}
