(* SPDX-License-Identifier: GPL-3.0-or-later *)

(* Pieces of a product of simplices. Coordinates x_0, ..., x_(n-1) >= 0 are barycentric; a piece
   is given by how the polynomials look in its own. `sign_holds` says what it comes to. *)

From Coq Require Import Reals QArith Qreals List Bool Arith Lia Lra.
Require Import SeamRing SeamNumber SeamSign.
Import ListNotations.
Local Open Scope R_scope.

Section Pieces.
  Variable o : Ring.
  Variable v : C o -> R.
  Hypothesis L : Laws o v.
  Variable n : nat.

  Let P := polynomials o n.
  Let pv (x : nat -> R) := pval o v x n.

  Lemma pval_ext x y k p : (forall i, (i < k)%nat -> x i = y i) ->
    pval o v x k p = pval o v y k p.
  Proof.
    induction k as [|k IH]; intros E; [reflexivity|]. simpl. rewrite (E k) by lia.
    assert (I : forall i, (i < k)%nat -> x i = y i) by (intros; apply E; lia).
    induction p as [|c p IHp]; simpl; [reflexivity|]. rewrite IHp, (IH c I). reflexivity.
  Qed.

  (* ---- Putting something in for the variables, given by how one multiplies by it ---- *)

  Fixpoint substitute (times : nat -> C P -> C P) (k : nat) : C (polynomials o k) -> C P :=
    match k with
    | O => number o n
    | S k => fold_right (fun c sum => add P (substitute times k c) (times k sum)) (zero P)
    end.

  Lemma substitute_val x y times k p :
    (forall i q, (i < k)%nat -> pv x (times i q) = y i * pv x q) ->
    pv x (substitute times k p) = pval o v y k p.
  Proof.
    pose proof (polynomials_laws o v x n L) as M. unfold pv, P in *.
    induction k as [|k IH]; intros T; simpl.
    - apply number_val. exact L.
    - assert (T' : forall i q, (i < k)%nat -> pval o v x n (times i q) = y i * pval o v x n q)
        by (intros; apply T; lia).
      induction p as [|c p IHp]; simpl.
      + apply M.
      + rewrite (law_add _ _ M), T, (IH c T'), IHp by lia. reflexivity.
  Qed.

  (* ---- Forms: each term times powers of what is 1 ---- *)

  Definition lower (groups : list (list nat)) (k : nat) (degrees : list nat) : list nat :=
    map (fun gd => if existsb (Nat.eqb k) (fst gd) then Nat.pred (snd gd) else snd gd)
      (combine groups degrees).

  Fixpoint times_ones (tables : list (list (C P))) (degrees : list nat) (p : C P) : C P :=
    match tables, degrees with
    | table :: tables, S d :: degrees => mul P (times_ones tables degrees p) (nth d table (one P))
    | _ :: tables, O :: degrees => times_ones tables degrees p
    | _, _ => p
    end.

  Fixpoint form (groups : list (list nat)) (tables : list (list (C P))) (k : nat)
    : list nat -> C (polynomials o k) -> C P :=
    match k with
    | O => fun degrees c => times_ones tables degrees (number o n c)
    | S k =>
        fix from (degrees : list nat) (l : list (C (polynomials o k))) : C P :=
          match l with
          | [] => zero P
          | c :: l =>
              let rest := times_variable o n k (from (lower groups k degrees) l) in
              if is_zero (polynomials o k) c then rest
              else add P (form groups tables k degrees c) rest
          end
    end.

  Definition are_one (x : nat -> R) (tables : list (list (C P))) :=
    Forall (Forall (fun w => pv x w = 1)) tables.

  Lemma nth_one x table d : Forall (fun w => pv x w = 1) table -> pv x (nth d table (one P)) = 1.
  Proof.
    pose proof (polynomials_laws o v x n L) as M. intros F.
    destruct (nth_in_or_default d table (one P)) as [I|E].
    - rewrite Forall_forall in F. exact (F _ I).
    - rewrite E. apply M.
  Qed.

  Lemma times_ones_val x tables : are_one x tables -> forall degrees p,
    pv x (times_ones tables degrees p) = pv x p.
  Proof.
    pose proof (polynomials_laws o v x n L) as M. intros T.
    induction T as [|table tables A B IH]; intros [|[|d] degrees] p; simpl; auto.
    unfold pv, P in *. rewrite (law_mul _ _ M), IH. unfold pv, P in *.
    pose proof (nth_one x table d A) as N. unfold pv, P in N. rewrite N. ring.
  Qed.

  Lemma form_val x groups tables : are_one x tables -> forall k degrees p, (k <= n)%nat ->
    pv x (form groups tables k degrees p) = pval o v x k p.
  Proof.
    intros T. pose proof (polynomials_laws o v x n L) as M.
    induction k as [|k IH]; intros degrees p K.
    - simpl. rewrite times_ones_val by exact T. apply number_val. exact L.
    - pose proof (polynomials_laws o v x k L) as N. revert degrees.
      induction p as [|c p IHp]; intros degrees.
      + apply M.
      + set (rest := times_variable o n k (form groups tables (S k) (lower groups k degrees) p)).
        change (form groups tables (S k) degrees (c :: p)) with
          (if is_zero (polynomials o k) c then rest else add P (form groups tables k degrees c) rest).
        assert (E : pv x rest = x k * pval o v x (S k) p).
        { unfold rest, pv, P. rewrite times_variable_val by (assumption || lia).
          specialize (IHp (lower groups k degrees)). unfold pv, P in IHp.
          rewrite IHp. reflexivity. }
        change (pval o v x (S k) (c :: p)) with (pval o v x k c + x k * pval o v x (S k) p).
        destruct (is_zero (polynomials o k) c) eqn:Z.
        * rewrite E, (law_is_zero _ _ N c Z). ring.
        * unfold pv, P. rewrite (law_add _ _ M). unfold pv, P in IH, E.
          rewrite IH, E by lia. reflexivity.
  Qed.

  (* The degree in the variables of a group. *)
  Fixpoint degree (group : list nat) (k : nat) : C (polynomials o k) -> nat :=
    match k with
    | O => fun _ => O
    | S k =>
        let counts := existsb (Nat.eqb k) group in
        (fix from (i : nat) (l : list (C (polynomials o k))) : nat :=
           match l with
           | [] => O
           | c :: l => Nat.max ((if counts then i else O) + degree group k c) (from (S i) l)
           end) O
    end.

  (* w, w^2, ... up to the count. *)
  Fixpoint table (w : C P) (last : C P) (count : nat) : list (C P) :=
    match count with O => [] | S count => last :: table w (mul P last w) count end.

  Lemma table_one x w : pv x w = 1 -> forall count last, pv x last = 1 ->
    Forall (fun w => pv x w = 1) (table w last count).
  Proof.
    pose proof (polynomials_laws o v x n L) as M. unfold pv, P in *. intros W.
    induction count as [|count IH]; intros last E; simpl; constructor; auto.
    apply IH. rewrite (law_mul _ _ M), E, W. ring.
  Qed.

  Definition to_form (groups : list (list nat)) (ones : list (C P)) (p : C P) : C P :=
    let degrees := map (fun g => degree g n p) groups in
    form groups (map (fun wd => table (fst wd) (fst wd) (snd wd)) (combine ones degrees)) n degrees p.

  Lemma to_form_val x groups ones p : Forall (fun w => pv x w = 1) ones ->
    pv x (to_form groups ones p) = pv x p.
  Proof.
    intros O. unfold to_form. rewrite form_val; [reflexivity| |lia].
    apply Forall_map, Forall_forall. intros [w d] I. simpl.
    rewrite Forall_forall in O. apply in_combine_l in I. apply table_one; apply O; exact I.
  Qed.

  (* ---- Splits ---- *)

  Record piece := {
    goal : C P;
    facts : list (list nat);
    conditions : list (C P * relation)
  }.

  Definition inside (x : nat -> R) (p : piece) := region_holds o v n x (facts p) (conditions p).

  Inductive step := Plain | Outside (i : nat) | Split (weights : list expr).

  Definition weight (ws : list (C o)) (k : nat) : C o := nth k ws (zero o).
  Definition is_positive (c : C o) : bool := match sign o c with Some Gt => true | _ => false end.
  Definition is_nonnegative (c : C o) : bool :=
    match sign o c with Some Gt | Some Eq => true | _ => false end.

  Definition is_one (c : C o) : bool := is_zero o (add o c (opp o (one o))).

  (* Times the old coordinate k in the new ones, where the split point takes the place of
     corner t. *)
  Definition times_old (ws : list (C o)) (t k : nat) (p : C P) : C P :=
    let w := weight ws k in
    if is_zero o w then times_variable o n k p
    else let share := times_variable o n t p in
         let weighed := if is_one w then share else scaled o n w share in
         if Nat.eqb k t then weighed else add P (times_variable o n k p) weighed.

  Definition new_fact (ws : list (C o)) (t : nat) (fact : list nat) : list nat :=
    if existsb (fun k => is_positive (weight ws k)) fact then t :: fact else fact.

  Definition part (ws : list (C o)) (p : piece) (t : nat) : piece := {|
    goal := substitute (times_old ws t) n (goal p);
    facts := map (new_fact ws t) (facts p);
    conditions := map (fun g => (substitute (times_old ws t) n (fst g), snd g)) (conditions p) |}.

  Definition places (ws : list (C o)) : list nat :=
    filter (fun t => is_positive (weight ws t)) (seq 0 n).

  (* The new coordinates of a point. *)
  Definition moved (ws : list (C o)) (t : nat) (x : nat -> R) (k : nat) : R :=
    let ratio := x t / v (weight ws t) in
    if Nat.eqb k t then ratio else x k - v (weight ws k) * ratio.

  Lemma times_old_val ws t x k p : (t < n)%nat -> (k < n)%nat -> 0 < v (weight ws t) ->
    pv (moved ws t x) (times_old ws t k p) = x k * pv (moved ws t x) p.
  Proof.
    intros T K W. pose proof (polynomials_laws o v (moved ws t x) n L) as M.
    assert (X : k <> t -> moved ws t x k = x k - v (weight ws k) * (x t / v (weight ws t))).
    { intros D. unfold moved. destruct (Nat.eqb_spec k t); [contradiction | reflexivity]. }
    unfold times_old. destruct (is_zero o (weight ws k)) eqn:Z.
    - unfold pv. rewrite times_variable_val by assumption. rewrite X.
      + rewrite (law_is_zero o v L _ Z). ring.
      + intros ->. rewrite (law_is_zero o v L _ Z) in W. lra.
    - set (share := times_variable o n t p).
      assert (S : pv (moved ws t x) share = x t / v (weight ws t) * pv (moved ws t x) p).
      { unfold share, pv. rewrite times_variable_val by assumption. unfold moved at 1.
        rewrite Nat.eqb_refl. reflexivity. }
      set (weighed := if is_one (weight ws k) then share else scaled o n (weight ws k) share).
      assert (E : pv (moved ws t x) weighed =
                  v (weight ws k) * (x t / v (weight ws t)) * pv (moved ws t x) p).
      { unfold weighed. destruct (is_one (weight ws k)) eqn:O.
        - apply (law_is_zero o v L) in O.
          rewrite (law_add o v L), (law_opp o v L), (law_one o v L) in O.
          rewrite S. replace (v (weight ws k)) with 1 by lra. ring.
        - unfold pv in *. rewrite scaled_number_val by exact L. rewrite S. ring. }
      destruct (Nat.eqb_spec k t) as [->|D].
      + rewrite E. field. lra.
      + unfold pv, P in *. rewrite (law_add _ _ M), E, times_variable_val by assumption.
        rewrite (X D). ring.
  Qed.

  Lemma is_positive_sound c : is_positive c = true -> 0 < v c.
  Proof.
    unfold is_positive. pose proof (sign_sound o v c) as S.
    destruct (sign o c) as [[]|]; try discriminate. intros _. exact (S Gt L eq_refl).
  Qed.

  Lemma is_nonnegative_sound c : is_nonnegative c = true -> 0 <= v c.
  Proof.
    unfold is_nonnegative. pose proof (sign_sound o v c) as S.
    destruct (sign o c) as [[]|]; try discriminate; intros _; specialize (S _ L eq_refl);
      simpl in S; lra.
  Qed.

  (* Of some places one has the least ratio. *)
  Lemma least (f : nat -> R) : forall l, l <> [] ->
    exists t, In t l /\ forall k, In k l -> f t <= f k.
  Proof.
    induction l as [|a [|b l] IH]; intros N; [congruence| |].
    - exists a. split; [left; reflexivity|]. intros k [->|[]]. lra.
    - destruct IH as (t & T & H); [discriminate|]. destruct (Rle_dec (f a) (f t)) as [A|A].
      + exists a. split; [left; reflexivity|]. intros k [->|K]; [lra|]. specialize (H k K). lra.
      + exists t. split; [right; exact T|]. intros k [->|K]; [lra | exact (H k K)].
  Qed.

  Definition is_split (ws : list (C o)) : bool :=
    if Nat.eqb (length ws) n
    then if forallb is_nonnegative ws then match places ws with [] => false | _ => true end else false
    else false.

  Lemma weight_nonneg ws k : forallb is_nonnegative ws = true -> 0 <= v (weight ws k).
  Proof.
    intros F. unfold weight. destruct (nth_in_or_default k ws (zero o)) as [I|E].
    - rewrite forallb_forall in F. apply is_nonnegative_sound, F, I.
    - rewrite E, (law_zero o v L). lra.
  Qed.

  Lemma in_some_part ws p x : is_split ws = true -> inside x p ->
    exists t, In t (places ws) /\ inside (moved ws t x) (part ws p t) /\
      pv (moved ws t x) (goal (part ws p t)) = pv x (goal p).
  Proof.
    unfold is_split. destruct (Nat.eqb_spec (length ws) n) as [E|]; [|discriminate].
    destruct (forallb is_nonnegative ws) eqn:W; [|discriminate]. intros S (X & O & F & G).
    destruct (least (fun t => x t / v (weight ws t)) (places ws)) as (t & T & H).
    { destruct (places ws); discriminate. }
    exists t. split; [exact T|]. unfold places in T. apply filter_In in T. destruct T as [T A].
    apply in_seq in T. apply is_positive_sound in A.
    assert (R0 : 0 <= x t / v (weight ws t)).
    { apply Rmult_le_pos; [apply X | left; apply Rinv_0_lt_compat; exact A]. }
    assert (Q : forall q, pv (moved ws t x) (substitute (times_old ws t) n q) = pval o v x n q).
    { intros q. apply substitute_val. intros i r I. apply times_old_val; [lia|lia|exact A]. }
    assert (N : forall k, 0 <= moved ws t x k).
    { intros k. unfold moved. destruct (Nat.eqb_spec k t); [exact R0|].
      pose proof (weight_nonneg ws k W) as B. pose proof (X k).
      destruct (Rle_lt_or_eq_dec _ _ B) as [B'|B']; [|rewrite <- B'; lra].
      destruct (le_lt_dec n k) as [Y|Y].
      - unfold weight in B'. rewrite nth_overflow, (law_zero o v L) in B' by lia. lra.
      - assert (I : In k (places ws)).
        { apply filter_In. split; [apply in_seq; lia|]. unfold is_positive.
          assert (J : is_nonnegative (weight ws k) = true).
          { rewrite forallb_forall in W. apply W. apply nth_In. lia. }
          unfold is_nonnegative in J. pose proof (sign_sound o v (weight ws k)) as Z.
          destruct (sign o (weight ws k)) as [[]|]; try discriminate; auto.
          specialize (Z _ L eq_refl). simpl in Z. lra. }
        specialize (H k I). simpl in H.
        apply (Rmult_le_compat_l (v (weight ws k))) in H; [|lra].
        replace (v (weight ws k) * (x k / v (weight ws k))) with (x k) in H by (field; lra). lra. }
    split; [split; [exact N|split; [|split]]|].
    - intros k K. unfold moved. destruct (Nat.eqb_spec k t); [lia|].
      unfold weight at 1. rewrite nth_overflow, (law_zero o v L), (O k K) by lia. ring.
    - simpl. apply Forall_map. revert F. apply Forall_impl. intros fact F.
      unfold fact_holds in *. apply Exists_exists in F. destruct F as (k & K & B).
      unfold new_fact. apply Exists_exists.
      destruct (existsb (fun k => is_positive (weight ws k)) fact) eqn:Z.
      + destruct (Rlt_dec 0 (x t / v (weight ws t))) as [Y|Y].
        * exists t. split; [left; reflexivity|]. unfold moved. rewrite Nat.eqb_refl. exact Y.
        * exists k. split; [right; exact K|]. unfold moved.
          assert (x t / v (weight ws t) = 0) as -> by lra.
          destruct (Nat.eqb_spec k t) as [->|]; [|lra]. exfalso. apply Y.
          apply Rmult_lt_0_compat; [exact B | apply Rinv_0_lt_compat; exact A].
      + exists k. split; [exact K|]. unfold moved.
        assert (is_positive (weight ws k) = false).
        { destruct (is_positive (weight ws k)) eqn:Y; [|reflexivity].
          assert (existsb (fun k => is_positive (weight ws k)) fact = true)
            by (apply existsb_exists; exists k; auto). congruence. }
        destruct (Nat.eqb_spec k t) as [->|].
        * apply Rmult_lt_0_compat; [exact B | apply Rinv_0_lt_compat; exact A].
        * assert (v (weight ws k) = 0) as ->; [|lra].
          destruct (le_lt_dec n k) as [U|U].
          { unfold weight. rewrite nth_overflow by lia. apply L. }
          assert (J : is_nonnegative (weight ws k) = true).
          { rewrite forallb_forall in W. apply W. apply nth_In. lia. }
          unfold is_nonnegative, is_positive in *. pose proof (sign_sound o v (weight ws k)) as V.
          destruct (sign o (weight ws k)) as [[]|]; try discriminate. exact (V _ L eq_refl).
    - simpl. apply Forall_map. revert G. apply Forall_impl. intros [q r] G. cbn [fst snd] in *.
      change (holds r (pv (moved ws t x) (substitute (times_old ws t) n q))).
      rewrite Q. exact G.
    - simpl. apply Q.
  Qed.

  (* ---- The steps of a certificate, depth first ---- *)

  Definition complement (r : relation) : relation :=
    match r with
    | Positive => Nonpositive | Nonnegative => Negative | Zero => Nonzero
    | Nonzero => Zero | Nonpositive => Positive | Negative => Nonnegative
    end.

  Lemma complement_sound r x : holds r x -> holds (complement r) x -> False.
  Proof. destruct r; simpl; lra. Qed.

  Definition is_outside (i : nat) (p : piece) : bool :=
    match nth_error (conditions p) i with
    | Some (g, r) => shows o (complement r) n g (facts p) (conditions p)
    | None => false
    end.

  Fixpoint run (syms : list (C o)) (r : relation) (steps : list step) (stack : list piece) : bool :=
    match steps, stack with
    | [], [] => true
    | s :: steps, p :: stack =>
        match s with
        | Plain => if shows o r n (goal p) (facts p) (conditions p)
                   then run syms r steps stack else false
        | Outside i => if is_outside i p then run syms r steps stack else false
        | Split weights =>
            let ws := map (value o syms) weights in
            if is_split ws then run syms r steps (map (part ws p) (places ws) ++ stack) else false
        end
    | _, _ => false
    end.

  Definition good (r : relation) (p : piece) := forall x, inside x p -> holds r (pv x (goal p)).

  Lemma run_sound syms r steps : forall stack, run syms r steps stack = true ->
    Forall (good r) stack.
  Proof.
    induction steps as [|s steps IH]; intros [|p stack]; simpl; try discriminate; auto.
    destruct s as [|i|weights].
    - destruct (shows _ _ _ _ _ _) eqn:S; [|discriminate]. intros H. constructor; [|auto].
      intros x I. exact (shows_sound o v L r n _ _ _ x I S).
    - unfold is_outside. destruct (nth_error (conditions p) i) as [[g q]|] eqn:E; [|discriminate].
      destruct (shows _ _ _ _ _ _) eqn:S; [|discriminate]. intros H. constructor; [|auto].
      intros x I. exfalso. pose proof (shows_sound o v L _ n _ _ _ x I S) as N.
      destruct I as (_ & _ & _ & G). rewrite Forall_forall in G.
      specialize (G _ (nth_error_In _ _ E)). exact (complement_sound _ _ G N).
    - set (ws := map (value o syms) weights). destruct (is_split ws) eqn:S; [|discriminate].
      intros H. apply IH, Forall_app in H. destruct H as [H K]. constructor; [|exact K].
      intros x I. destruct (in_some_part ws p x S I) as (t & T & J & E).
      rewrite Forall_map, Forall_forall in H. rewrite <- E. exact (H t T _ J).
  Qed.

  (* ---- Of coordinates whose weighted sum is 1 one with a positive weight is positive ---- *)

  Definition first_variable (m : monomial) : nat := match m with [] => O | (k, _) :: _ => k end.
  Definition is_sum (ss : list signed) : bool :=
    forallb (fun s => match fst s with [] => false | _ => true end && is_not Lt s) ss.
  Definition fact_of (ss : list signed) : list nat :=
    map (fun s => first_variable (fst s)) (filter (fun s => match snd s with Some Gt => true | _ => false end) ss).

  Lemma fact_of_sound x ts : (forall k, 0 <= x k) -> is_sum (signs o ts) = true ->
    0 < tval o v x ts -> fact_holds x (fact_of (signs o ts)).
  Proof.
    intros X. induction ts as [|[m c] ts IH]; simpl; [lra|]. unfold fact_of; simpl.
    rewrite !andb_true_iff. intros [[N S] H] T. pose proof (mval_nonneg x m X).
    pose proof (sign_sound o v c) as Z. unfold is_not in S; simpl in S.
    destruct (sign o c) as [[]|]; try discriminate; specialize (Z _ L eq_refl); simpl in Z; simpl.
    - apply IH; [exact H|]. rewrite Z in T. lra.
    - destruct (Rlt_dec 0 (tval o v x ts)) as [Y|Y].
      + apply Exists_cons_tl. apply IH; assumption.
      + apply Exists_cons_hd. destruct m as [|[k e] m]; [discriminate|]. simpl.
        destruct (Rle_lt_or_eq_dec 0 (x k) (X k)) as [K|K]; [exact K|]. exfalso.
        cbn [mval] in T. rewrite <- K in T. simpl in T. lra.
  Qed.
End Pieces.

(* ---- What it comes to ---- *)

Fixpoint all_nonnegative (xs : list R) : Prop :=
  match xs with [] => True | x :: xs => 0 <= x /\ all_nonnegative xs end.

Fixpoint all_one (env : list R) (ones : list expr) : Prop :=
  match ones with [] => True | e :: ones => eval env e = 1 /\ all_one env ones end.

Fixpoint all_positive (xs : list R) (open : list nat) : Prop :=
  match open with [] => True | k :: open => 0 < nth k xs 0 /\ all_positive xs open end.

Fixpoint all_hold (env : list R) (conditions : list (expr * relation)) : Prop :=
  match conditions with
  | [] => True
  | c :: conditions => holds (snd c) (eval env (fst c)) /\ all_hold env conditions
  end.

(* The factors of a product: the numbers of its coordinates, and their weighted sum, which is 1. *)
Definition sign_check (rounds : nat) (gs : list generator) (n : nat)
  (factors : list (list nat * expr)) (open : list nat) (defs : list expr)
  (conditions : list (expr * relation)) (goal : expr) (r : relation) (steps : list step) : bool :=
  let t := tower rounds gs in
  let o := ring t in
  let P := polynomials o n in
  let names := start t n in
  let ones := map (fun f => value P names (snd f)) factors in
  let env := values P names defs in
  let prepare := fun e => to_form o n (map fst factors) ones (value P env e) in
  let sums := map (fun w => signs o (terms o n w)) ones in
  if forallb is_sum sums
  then run o n (symbols t) r steps
         [{| goal := prepare goal;
             facts := map fact_of sums ++ map (fun k => [k]) open;
             conditions := map (fun c => (prepare (fst c), snd c)) conditions |}]
  else false.

Lemma at_list_nonneg xs : all_nonnegative xs -> forall k, 0 <= at_list xs k.
Proof.
  unfold at_list. induction xs as [|x xs IH]; intros H [|k]; simpl in *;
    first [lra | exact (proj1 H) | exact (IH (proj2 H) k)].
Qed.

Lemma value_at t v xs defs named e gens : Laws (ring t) v -> map v (symbols t) = gens ->
  defined (gens ++ xs) defs named ->
  pval (ring t) v (at_list xs) (length xs)
    (value (polynomials (ring t) (length xs))
       (values (polynomials (ring t) (length xs)) (start t (length xs)) defs) e) =
  eval ((gens ++ xs) ++ named) e.
Proof. apply computed_val. Qed.

Theorem sign_holds r gs gens xs factors open defs named conditions goal steps :
  roots gs gens -> all_nonnegative xs ->
  all_one (rev gens ++ xs) (map snd factors) -> all_positive xs open ->
  defined (rev gens ++ xs) defs named ->
  all_hold ((rev gens ++ xs) ++ named) conditions -> forall rounds,
  sign_check rounds gs (length xs) factors open defs conditions goal r steps = true ->
  holds r (eval ((rev gens ++ xs) ++ named) goal).
Proof.
  intros G X W O D H rounds E. destruct (tower_sound rounds gs gens G) as (v & L & S).
  unfold sign_check in E. set (t := tower rounds gs) in *. set (n := length xs) in *.
  set (names := start t n) in *.
  set (P := polynomials (ring t) n) in *.
  set (ones := map (fun f => value P names (snd f)) factors) in *.
  pose proof (at_list_nonneg xs X) as N.
  assert (A : Forall (fun w => pval (ring t) v (at_list xs) n w = 1) ones).
  { unfold ones. clear E H O. induction factors as [|[g w] factors IH]; simpl in *; constructor.
    - rewrite <- (proj1 W).
      etransitivity; [exact (value_sound P (pval (ring t) v (at_list xs) n) names w
                               (polynomials_laws (ring t) v (at_list xs) n L))|].
      f_equal. exact (start_val t v xs (rev gens) L S).
    - apply IH. tauto. }
  destruct (forallb is_sum _) eqn:F; [|discriminate].
  apply (run_sound (ring t) v L n) in E. inversion E as [|? ? I _]; subst.
  specialize (I (at_list xs)). cbn [SeamPieces.goal] in I.
  rewrite (to_form_val (ring t) v L n (at_list xs) _ ones _ A) in I.
  rewrite <- (value_at t v xs defs named goal (rev gens) L S D).
  apply I. split; [exact N|]. split; [|split].
  - intros k K. unfold at_list. apply nth_overflow. exact K.
  - cbn [facts]. apply Forall_app. split.
    + rewrite forallb_forall in F. apply Forall_forall. intros fact J.
      apply in_map_iff in J. destruct J as (ss & <- & J). pose proof (F ss J) as K.
      apply in_map_iff in J. destruct J as (w & <- & J).
      apply (fact_of_sound (ring t) v L); [exact N | exact K|].
      rewrite (terms_val (ring t) v L). rewrite Forall_forall in A. rewrite (A w J). lra.
    + clear - O. induction open as [|k open IH]; simpl; constructor.
      * apply Exists_cons_hd. exact (proj1 O).
      * apply IH. exact (proj2 O).
  - cbn [SeamPieces.conditions]. clear - H A D L S. induction conditions as [|[c q] conditions IH];
      simpl; constructor.
    + cbn [fst snd]. rewrite (to_form_val (ring t) v L _ (at_list xs) _ ones _ A).
      pose proof (proj1 H) as K. simpl in K.
      rewrite <- (value_at t v xs defs named c (rev gens) L S D) in K. exact K.
    + apply IH. exact (proj2 H).
Qed.

(* ---- Coordinates of points in the simplices that are written as inequalities ---- *)

Lemma in_segment a b x : b - a > 0 -> a <= x -> x <= b ->
  exists l m, 0 <= l /\ 0 <= m /\ l + m = 1 /\ x = a * l + b * m /\
    (x < b -> 0 < l) /\ (a < x -> 0 < m).
Proof.
  intros D A B. exists ((b - x) * / (b - a)), ((x - a) * / (b - a)).
  assert (I : 0 < / (b - a)) by (apply Rinv_0_lt_compat; lra).
  repeat split; try (apply Rmult_le_pos; lra); try (field; lra);
    intros; apply Rmult_lt_0_compat; lra.
Qed.

Lemma in_ray_up a x : a <= x ->
  exists l m, 0 <= l /\ 0 <= m /\ l = 1 /\ x = a * l + m /\ (a < x -> 0 < m).
Proof. intros A. exists 1, (x - a). repeat split; lra. Qed.

Lemma in_ray_down a x : x <= a ->
  exists l m, 0 <= l /\ 0 <= m /\ l = 1 /\ x = a * l - m /\ (x < a -> 0 < m).
Proof. intros A. exists 1, (a - x). repeat split; lra. Qed.

Lemma in_triangle x y : 0 <= x -> 0 <= y -> x + y <= 1 ->
  exists l m n, 0 <= l /\ 0 <= m /\ 0 <= n /\ l + m + n = 1 /\ x = m /\ y = n /\
    (x + y < 1 -> 0 < l) /\ (0 < x -> 0 < m) /\ (0 < y -> 0 < n).
Proof. intros X Y Z. exists (1 - x - y), x, y. repeat split; lra. Qed.
