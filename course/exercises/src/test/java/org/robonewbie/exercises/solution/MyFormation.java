package org.robonewbie.exercises.solution;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.tactics.Assignment;
import org.robonewbie.team.talk.Talk;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.WorldModel;

/** Three places around the ball, shared so that all ways together are shortest. */
public final class MyFormation extends Agent {

    private final WorldModel world = new WorldModel();
    private final Footwork feet = new Footwork(walk);
    private final Gaze gaze = new Gaze(new Limbs(nao, walk, motions, lookAround));

    /** Creates the solution. */
    public MyFormation() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(Footwork.STYLE);
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        world.listen(nao);
        gaze.look(world);
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (motions.isFinished() && world.ballAgeSeconds() < 3) {
            Translation2d place = place();
            feet.go(world, place, world.ball().minus(place).degrees());
        }
        speak();
    }

    private Translation2d place() {
        List<Translation2d> places = places();
        List<Translation2d> players = new ArrayList<>();
        SortedMap<Integer, Translation2d> byNumber = new TreeMap<>();
        world.mates().forEach(mate -> byNumber.put(mate.number(), mate.place()));
        byNumber.put(world.number(), world.place());
        players.addAll(byNumber.values());
        double[][] cost = new double[players.size()][places.size()];
        for (int i = 0; i < players.size(); i++) {
            for (int j = 0; j < places.size(); j++) {
                cost[i][j] = players.get(i).distanceTo(places.get(j));
            }
        }
        int own = byNumber.headMap(world.number()).size();
        return places.get(Assignment.cheapest(cost)[own]);
    }

    private List<Translation2d> places() {
        Translation2d ball = world.ball();
        Translation2d atBall = ball.plus(new Translation2d(-0.55, 0));
        Translation2d before = ball.towards(world.ourGoal(), 2);
        return List.of(atBall, before, freePlace(ball));
    }

    /** A place ahead of the ball, so far to the middle of the pitch that the opponent is not in the way. */
    private static Translation2d freePlace(Translation2d ball) {
        double side = ball.y() > 0 ? -1 : 1;
        return ball.plus(Translation2d.polar(side * 60, 2.6));
    }

    private void speak() {
        if (Talk.isMyTurn(nao.getTime(), nao.getNumber())) {
            nao.say(new TeamMessage(
                            nao.getNumber(),
                            world.pose(),
                            nao.isFallen(),
                            TeamRole.SUPPORTER,
                            world.ball(),
                            world.ballVelocity(),
                            world.ownBallAgeSeconds(),
                            9,
                            0,
                            Translation2d.ORIGIN)
                    .encode());
        }
    }
}
