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
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Mirror;
import org.robonewbie.team.skill.Dribble;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.GetUp;
import org.robonewbie.team.skill.Goalkeeping;
import org.robonewbie.team.skill.Kick;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.skill.PathPlanner;
import org.robonewbie.team.tactics.Assignment;
import org.robonewbie.team.tactics.Formation;
import org.robonewbie.team.tactics.KickChoice;
import org.robonewbie.team.tactics.KickOffPositions;
import org.robonewbie.team.tactics.Plan;
import org.robonewbie.team.tactics.Roles;
import org.robonewbie.team.tactics.SetPlay;
import org.robonewbie.team.tactics.Strategy;
import org.robonewbie.team.talk.Talk;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.BallFilter;
import org.robonewbie.team.world.Mate;
import org.robonewbie.team.world.Situation;
import org.robonewbie.team.world.WorldModel;

/**
 * Roots for TeaVM's dead-code elimination: classes that only students' programs use and that TeaVM would otherwise remove.
 */
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
            Mirror.class,
            Dribble.class,
            Footwork.class,
            Gaze.class,
            GetUp.class,
            Goalkeeping.class,
            Kick.class,
            Limbs.class,
            PathPlanner.class,
            Assignment.class,
            Formation.class,
            KickChoice.class,
            KickOffPositions.class,
            Plan.class,
            Roles.class,
            SetPlay.class,
            Strategy.class,
            TeamRole.class,
            Talk.class,
            TeamMessage.class,
            BallFilter.class,
            Mate.class,
            Situation.class,
            Angles.class,
            Pose2d.class,
            Translation2d.class,
            WorldModel.class);

    private LibraryRoots() {}

    /** {@return the number of classes that are kept for students' programs} */
    static int count() {
        return CLASSES.size();
    }
}
