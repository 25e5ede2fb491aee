//! Steps of several laws that are met together: whether their order matters.

use crate::engine::cells::Stand;
use crate::engine::crossing::Side;
use crate::engine::equations::{Equations, Switching};
use crate::engine::jump::Passage;
use crate::engine::law;
use crate::engine::record::State;
use crate::engine::vector::Vector;
use crate::tolerance::events::ORDER;

/// Whether `law` meets its boundary together with a law of another phase, and the order of the two steps changes the speeds. The computed
/// motion is then one of several possible ones.
pub fn matters(
    equations: &dyn Equations,
    (laws, switches, k): Stand<'_>,
    state: &State,
    law: usize,
    side: Side,
) -> bool {
    let pass = |(l, side): (usize, Side), (speeds, k): &mut (Vector, Vec<f64>)| {
        // The second step is met only if its phase still moves towards it after the first.
        if side.sign() * laws[l].surface.normal.dot(speeds) <= 0.0 {
            return;
        }
        let dv = law::barrier(equations, (laws, switches, k), l, side, state);
        if laws[l].surface.pass(speeds, side, dv) == Passage::Transmitted {
            *k = law::beyond(equations, (laws, switches, k), l, side, state);
        }
    };
    let others = (0..laws.len()).filter_map(|i| {
        let v = laws[i].surface.normal.dot(&state.q_dot);
        let side = if v > 0.0 { Side::Upper } else { Side::Lower };
        (laws[i].phase != laws[law].phase && laws[i].is_at(side, state, 4.0 * laws[i].rounding())).then_some((i, side))
    });
    let differs = |other| {
        let (mut there, mut back) = ((state.q_dot.clone(), k.to_vec()), (state.q_dot.clone(), k.to_vec()));
        pass((law, side), &mut there);
        pass(other, &mut there);
        pass(other, &mut back);
        pass((law, side), &mut back);
        (&there.0 - &back.0).amax() > ORDER * there.0.amax()
    };
    laws[law].switching == Switching::WithJump && others.into_iter().any(differs)
}
