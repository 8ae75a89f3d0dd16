(* SPDX-License-Identifier: GPL-3.0-or-later *)

(* Signs of polynomials on products of simplices, by the coefficients of forms in barycentric
   coordinates, over pieces into which the product is cut. `sign_holds` says what a computation
   that ends in `true` shows. *)

From Coq Require Import Reals QArith Qreals List Bool Arith Lia Lra.
Require Import SeamRing SeamNumber.
Import ListNotations.
Local Open Scope R_scope.

(* ---- Monomials: variables with their powers, exponents less 1 ---- *)

Definition monomial := list (nat * nat).

Fixpoint mval (x : nat -> R) (m : monomial) : R :=
  match m with [] => 1 | (k, e) :: m => x k ^ S e * mval x m end.

(* Whether all its variables are among those. *)
Definition among (known : list nat) (m : monomial) : bool :=
  forallb (fun factor => existsb (Nat.eqb (fst factor)) known) m.

Lemma existsb_in k known : existsb (Nat.eqb k) known = true <-> In k known.
Proof.
  rewrite existsb_exists. split.
  - intros (j & J & E). apply Nat.eqb_eq in E. subst. exact J.
  - intros K. exists k. split; [exact K | apply Nat.eqb_refl].
Qed.

Lemma mval_nonneg x m : (forall k, 0 <= x k) -> 0 <= mval x m.
Proof.
  intros X. induction m as [|[k e] m IH]; cbn [mval]; [lra|].
  apply Rmult_le_pos; [apply pow_le; apply X | exact IH].
Qed.

Lemma mval_pos x known m : (forall k, In k known -> 0 < x k) -> among known m = true ->
  0 < mval x m.
Proof.
  intros K. induction m as [|[k e] m IH]; cbn [mval among forallb fst]; [lra|].
  rewrite andb_true_iff, existsb_in. intros [I A].
  apply Rmult_lt_0_compat; [apply pow_lt; auto | auto].
Qed.

Lemma mval_zero x known m : (forall k, ~ In k known -> x k = 0) -> among known m = false ->
  mval x m = 0.
Proof.
  intros K. induction m as [|[k e] m IH]; cbn [mval among forallb fst]; [discriminate|].
  destruct (existsb (Nat.eqb k) known) eqn:E; simpl andb; intros A.
  - rewrite IH by exact A. ring.
  - rewrite K; [simpl; ring|]. rewrite <- existsb_in, E. discriminate.
Qed.

(* ---- The terms of a polynomial ---- *)

Section Terms.
  Variable o : Ring.
  Variable v : C o -> R.
  Hypothesis L : Laws o v.

  Definition with_power (k i : nat) (t : monomial * C o) : monomial * C o :=
    match i with O => t | S e => ((k, e) :: fst t, snd t) end.

  Fixpoint terms (n : nat) : C (polynomials o n) -> list (monomial * C o) :=
    match n with
    | O => fun c => if is_zero o c then [] else [([], c)]
    | S n =>
        fix list_terms_from (l : list (C (polynomials o n))) : list (monomial * C o) :=
          (fix from (i : nat) (l : list (C (polynomials o n))) :=
             match l with
             | [] => []
             | p :: l => map (with_power n i) (terms n p) ++ from (S i) l
             end) O l
    end.

  Definition tval (x : nat -> R) (ts : list (monomial * C o)) : R :=
    fold_right (fun t sum => v (snd t) * mval x (fst t) + sum) 0 ts.

  Lemma tval_app x a b : tval x (a ++ b) = tval x a + tval x b.
  Proof. induction a; simpl; [ring|]. rewrite IHa. ring. Qed.

  Lemma with_power_val x k i ts : tval x (map (with_power k i) ts) = x k ^ i * tval x ts.
  Proof.
    induction ts as [|[m c] ts IH]; simpl; [ring|]. rewrite IH.
    destruct i; simpl; ring.
  Qed.

  Lemma terms_val x n p : tval x (terms n p) = pval o v x n p.
  Proof.
    induction n as [|n IH]; simpl.
    - destruct (is_zero o p) eqn:E; simpl; [symmetry; apply (law_is_zero o v L _ E) | ring].
    - assert (G : forall l i,
        tval x ((fix from (i : nat) (l : list (C (polynomials o n))) :=
          match l with
          | [] => []
          | p :: l => map (with_power n i) (terms n p) ++ from (S i) l
          end) i l) = x n ^ i * lval (polynomials o n) (pval o v x n) (x n) l).
      { induction l as [|q l IHl]; intros i; simpl; [ring|].
        rewrite tval_app, with_power_val, IH, IHl. simpl. ring. }
      destruct p as [|q p].
      + reflexivity.
      + etransitivity; [exact (G (q :: p) O) | simpl; ring].
  Qed.

  (* ---- Signs of terms ---- *)

  Definition signed := (monomial * option comparison)%type.

  Definition signs (ts : list (monomial * C o)) : list signed :=
    map (fun t => (fst t, sign o (snd t))) ts.

  Definition is_not (c : comparison) (s : signed) : bool :=
    match snd s, c with
    | Some Gt, Gt | Some Lt, Lt | Some Eq, Eq | None, _ => false | _, _ => true
    end.

  Lemma tval_nonneg x ts : (forall k, 0 <= x k) -> forallb (is_not Lt) (signs ts) = true ->
    0 <= tval x ts.
  Proof.
    intros X. induction ts as [|[m c] ts IH]; simpl; [lra|].
    rewrite andb_true_iff. intros [S Z]. specialize (IH Z).
    pose proof (mval_nonneg x m X). pose proof (sign_sound o v c) as T.
    unfold is_not in S; simpl in S.
    destruct (sign o c) as [[]|]; try discriminate; specialize (T _ L eq_refl); simpl in T; nra.
  Qed.

  Definition is_positive_among (known : list nat) (s : signed) : bool :=
    match snd s with Some Gt => among known (fst s) | _ => false end.

  Lemma tval_pos x known ts : (forall k, 0 <= x k) -> (forall k, In k known -> 0 < x k) ->
    forallb (is_not Lt) (signs ts) = true ->
    existsb (is_positive_among known) (signs ts) = true -> 0 < tval x ts.
  Proof.
    intros X K. induction ts as [|[m c] ts IH]; simpl; [discriminate|].
    rewrite andb_true_iff, orb_true_iff. intros [S Z] P.
    pose proof (mval_nonneg x m X). pose proof (sign_sound o v c) as T.
    pose proof (tval_nonneg x ts X Z) as N.
    unfold is_not in S; simpl in S. unfold is_positive_among in P; simpl in P.
    destruct (sign o c) as [[]|]; try discriminate; specialize (T _ L eq_refl); simpl in T.
    - destruct P as [P|P]; [discriminate|]. specialize (IH Z P). nra.
    - destruct P as [P|P].
      + pose proof (mval_pos x known m K P). nra.
      + specialize (IH Z P). nra.
  Qed.

  (* Where exactly the known variables are not 0, other terms are. *)
  Definition left (known : list nat) (ss : list signed) := filter (fun s => among known (fst s)) ss.

  Lemma tval_left x known ts : (forall k, ~ In k known -> x k = 0) ->
    exists us, signs us = left known (signs ts) /\ tval x us = tval x ts.
  Proof.
    intros K. induction ts as [|[m c] ts (us & S & E)]; simpl.
    - exists []. auto.
    - destruct (among known m) eqn:A.
      + exists ((m, c) :: us). simpl. rewrite S, E. auto.
      + exists us. rewrite (mval_zero x known m K A), E. split; [exact S | ring].
  Qed.

  Definition negated (ss : list signed) : list signed :=
    map (fun s => (fst s, match snd s with Some c => Some (CompOpp c) | None => None end)) ss.

  (* The sign of a sum of the terms where all the known variables are positive. *)
  Definition common_sign (known : list nat) (ss : list signed) : option comparison :=
    if forallb (is_not Lt) ss
    then if existsb (is_positive_among known) ss then Some Gt
         else if forallb (is_not Gt) ss then Some Eq else None
    else if forallb (is_not Gt) ss
         then if existsb (is_positive_among known) (negated ss) then Some Lt else None
         else None.

  Lemma tval_nonpos x ts : (forall k, 0 <= x k) -> forallb (is_not Gt) (signs ts) = true ->
    tval x ts <= 0.
  Proof.
    intros X. induction ts as [|[m c] ts IH]; simpl; [lra|].
    rewrite andb_true_iff. intros [S Z]. specialize (IH Z).
    pose proof (mval_nonneg x m X). pose proof (sign_sound o v c) as T.
    unfold is_not in S; simpl in S.
    destruct (sign o c) as [[]|]; try discriminate; specialize (T _ L eq_refl); simpl in T; nra.
  Qed.

  Lemma tval_neg x known ts : (forall k, 0 <= x k) -> (forall k, In k known -> 0 < x k) ->
    forallb (is_not Gt) (signs ts) = true ->
    existsb (is_positive_among known) (negated (signs ts)) = true -> tval x ts < 0.
  Proof.
    intros X K. induction ts as [|[m c] ts IH]; simpl; [discriminate|].
    rewrite andb_true_iff, orb_true_iff. intros [S Z] P.
    pose proof (mval_nonneg x m X). pose proof (sign_sound o v c) as T.
    pose proof (tval_nonpos x ts X Z) as N.
    unfold is_not in S; simpl in S. unfold is_positive_among in P; simpl in P.
    destruct (sign o c) as [[]|]; try discriminate; specialize (T _ L eq_refl); simpl in T, P.
    - destruct P as [P|P]; [discriminate|]. specialize (IH Z P). nra.
    - destruct P as [P|P].
      + pose proof (mval_pos x known m K P). nra.
      + specialize (IH Z P). nra.
  Qed.

  Lemma common_sign_sound x known ts c : (forall k, 0 <= x k) ->
    (forall k, In k known -> 0 < x k) ->
    common_sign known (signs ts) = Some c -> has_sign c (tval x ts).
  Proof.
    intros X K. unfold common_sign. destruct (forallb (is_not Lt) (signs ts)) eqn:N.
    - destruct (existsb _ _) eqn:E.
      + intros S; injection S; intros; subst. exact (tval_pos x known ts X K N E).
      + destruct (forallb (is_not Gt) (signs ts)) eqn:P; [|discriminate].
        intros S; injection S; intros; subst. pose proof (tval_nonneg x ts X N).
        pose proof (tval_nonpos x ts X P). simpl. lra.
    - destruct (forallb (is_not Gt) (signs ts)) eqn:P; [|discriminate].
      destruct (existsb _ _) eqn:E; [|discriminate].
      intros S; injection S; intros; subst. exact (tval_neg x known ts X K P E).
  Qed.

  (* ---- Every set of corners that a point may have a share in ---- *)

  (* Of each fact one variable at least is positive; each condition holds. *)
  Definition is_broken (known : list nat) (condition : list signed * relation) : bool :=
    match common_sign known (left known (fst condition)) with
    | Some c => negb (allows (snd condition) c)
    | None => false
    end.

  Definition is_missed (known : list nat) (fact : list nat) : bool :=
    negb (existsb (fun k => existsb (Nat.eqb k) known) fact).

  Fixpoint everywhere (goal : list signed) (facts : list (list nat))
    (conditions : list (list signed * relation)) (open : list nat) (known : list nat) : bool :=
    if existsb (is_positive_among known) goal then true
    else match open with
         | [] => existsb (is_missed known) facts || existsb (is_broken known) conditions
         | k :: open => if everywhere goal facts conditions open known
                        then everywhere goal facts conditions open (k :: known) else false
         end.

  Definition fact_holds (x : nat -> R) (fact : list nat) := Exists (fun k => 0 < x k) fact.

  Definition conditions_hold (x : nat -> R) (conditions : list (list (monomial * C o) * relation)) :=
    Forall (fun g => holds (snd g) (tval x (fst g))) conditions.

  Definition signed_conditions (conditions : list (list (monomial * C o) * relation)) :=
    map (fun g => (signs (fst g), snd g)) conditions.

  Lemma everywhere_sound x goal facts conditions : (forall k, 0 <= x k) ->
    forallb (is_not Lt) (signs goal) = true ->
    Forall (fact_holds x) facts -> conditions_hold x conditions ->
    forall open known, (forall k, In k known -> 0 < x k) ->
      (forall k, ~ In k known -> ~ In k open -> x k = 0) ->
      everywhere (signs goal) facts (signed_conditions conditions) open known = true ->
      0 < tval x goal.
  Proof.
    intros X N F G. induction open as [|k open IH]; intros known K O; cbn [everywhere].
    - destruct (existsb _ _) eqn:E; [intros _; exact (tval_pos x known goal X K N E)|].
      rewrite orb_true_iff. intros [M|B]; exfalso.
      + apply existsb_exists in M. destruct M as (fact & I & M). rewrite Forall_forall in F.
        specialize (F fact I). apply Exists_exists in F. destruct F as (k & J & P).
        unfold is_missed in M. apply negb_true_iff in M.
        assert (In k known).
        { destruct (in_dec Nat.eq_dec k known) as [Y|Y]; [exact Y|].
          rewrite (O k Y (fun f => f)) in P. lra. }
        assert (existsb (fun k => existsb (Nat.eqb k) known) fact = true).
        { apply existsb_exists. exists k. split; [exact J | apply existsb_in; assumption]. }
        congruence.
      + apply existsb_exists in B. destruct B as (c & I & B). unfold signed_conditions in I.
        apply in_map_iff in I. destruct I as ([ts r] & <- & I). unfold conditions_hold in G.
        rewrite Forall_forall in G. specialize (G _ I). unfold is_broken in B; simpl in *.
        destruct (tval_left x known ts (fun k Y => O k Y (fun f => f))) as (us & U & V).
        rewrite <- U in B. destruct (common_sign known (signs us)) as [s|] eqn:S; [|discriminate].
        apply negb_true_iff in B.
        apply (allows_not r s _ (common_sign_sound x known us s X K S) B). rewrite V. exact G.
    - destruct (existsb _ _) eqn:E; [intros _; exact (tval_pos x known goal X K N E)|].
      destruct (everywhere _ _ _ open known) eqn:Z; [|discriminate]. intros W.
      destruct (Rle_lt_or_eq_dec 0 (x k) (X k)) as [P|P].
      + apply (IH (k :: known)); [|simpl|exact W].
        * intros j [->|J]; auto.
        * intros j A B. apply O; [intros J; apply A; right; exact J|].
          intros [J|J]; [apply A; left; exact J | exact (B J)].
      + apply (IH known); [exact K| |exact Z].
        intros j A B. destruct (Nat.eq_dec j k) as [->|D]; [congruence|].
        apply O; [exact A|]. intros [J|J]; auto.
  Qed.

  (* Whether the polynomial has the sign at every point of a piece. *)
  Definition is_above (strict : bool) (n : nat) (p : C (polynomials o n)) (facts : list (list nat))
    (conditions : list (C (polynomials o n) * relation)) : bool :=
    let goal := signs (terms n p) in
    if forallb (is_not Lt) goal
    then if strict
         then everywhere goal facts (map (fun g => (signs (terms n (fst g)), snd g)) conditions)
                (seq 0 n) []
         else true
    else false.

  Definition shows (r : relation) (n : nat) (p : C (polynomials o n)) (facts : list (list nat))
    (conditions : list (C (polynomials o n) * relation)) : bool :=
    match r with
    | Positive => is_above true n p facts conditions
    | Nonnegative => is_above false n p facts conditions
    | Negative => is_above true n (opp _ p) facts conditions
    | Nonpositive => is_above false n (opp _ p) facts conditions
    | Zero => false
    | Nonzero => if is_above true n p facts conditions then true
                 else is_above true n (opp _ p) facts conditions
    end.

  Definition region_holds (n : nat) (x : nat -> R) (facts : list (list nat))
    (conditions : list (C (polynomials o n) * relation)) : Prop :=
    (forall k, 0 <= x k) /\ (forall k, (n <= k)%nat -> x k = 0) /\ Forall (fact_holds x) facts /\
    Forall (fun g => holds (snd g) (pval o v x n (fst g))) conditions.

  Lemma is_above_sound strict n p facts conditions x : region_holds n x facts conditions ->
    is_above strict n p facts conditions = true ->
    if strict then 0 < pval o v x n p else 0 <= pval o v x n p.
  Proof.
    intros (X & O & F & G). unfold is_above. destruct (forallb _ _) eqn:N; [|discriminate].
    rewrite <- terms_val. destruct strict; [|intros _; exact (tval_nonneg x _ X N)].
    intros E.
    apply (everywhere_sound x _ facts (map (fun g => (terms n (fst g), snd g)) conditions) X N F)
      with (open := seq 0 n) (known := []).
    - unfold conditions_hold. apply Forall_map. revert G. apply Forall_impl. intros [q r].
      simpl. rewrite terms_val. auto.
    - intros k [].
    - intros k _ I. apply O. rewrite in_seq in I. lia.
    - unfold signed_conditions. rewrite map_map. exact E.
  Qed.

  Lemma shows_sound r n p facts conditions x : region_holds n x facts conditions ->
    shows r n p facts conditions = true -> holds r (pval o v x n p).
  Proof.
    intros H. pose proof (law_opp _ _ (polynomials_laws o v x n L) p) as E.
    pose proof (fun s q => is_above_sound s n q facts conditions x H) as A.
    unfold shows; destruct r; cbn [holds]; intros S.
    - specialize (A true _ S); simpl in A; lra.
    - specialize (A false _ S); simpl in A; lra.
    - discriminate.
    - destruct (is_above true n p _ _) eqn:U.
      + specialize (A true _ U); simpl in A; lra.
      + specialize (A true _ S); simpl in A; lra.
    - specialize (A false _ S); simpl in A; lra.
    - specialize (A true _ S); simpl in A; lra.
  Qed.
End Terms.
